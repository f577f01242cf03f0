# run(command...): ends the test with what the command said where it fails; else that is in `output`.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nexit code ${code}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# build_and_run(SOURCE PREFIX [options...]): a project against what is installed there, each of its programs run.
function(build_and_run source prefix)
  cmake_path(GET source FILENAME name)
  set(build ${WORK_DIR}/examples-${name})
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -DCMAKE_PREFIX_PATH=${prefix} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build})
  file(GLOB programs ${source}/[0-9]*.c ${source}/[0-9]*.cpp)
  foreach(program IN LISTS programs)
    cmake_path(GET program STEM name)
    run(${build}/${name})
  endforeach()
endfunction()

# compile_by_pkg_config(SOURCE PREFIX): the example in C, by the flags of pkg-config alone, with sanitizers where the
# library has them.
function(compile_by_pkg_config source prefix)
  set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
  run(pkg-config --cflags --libs gmcr-c)
  separate_arguments(flags UNIX_COMMAND "${output} ${CXX_FLAGS}")
  run(cc -std=c99 -Wall -Wextra -Wpedantic -Werror ${source} -o ${WORK_DIR}/by_pkg_config ${flags} -lm
      -Wl,-rpath,${prefix}/${LIBDIR})
  run(${WORK_DIR}/by_pkg_config)
endfunction()
