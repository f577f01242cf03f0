# The whole would compile all anew; ALL=ON does so, by hand. Its least part shows that the project can be a folder of
# another, which installs nothing of it.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/embedded -B ${WORK_DIR} -G ${GENERATOR} -DGMCR=${ROOT}
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
if(ALL)
  run(${CMAKE_COMMAND} --build ${WORK_DIR} -j2)
  run(${WORK_DIR}/robot)
else()
  run(${CMAKE_COMMAND} --build ${WORK_DIR} --target gmcr_parallel)
endif()
run(${CMAKE_COMMAND} --install ${WORK_DIR} --prefix ${WORK_DIR}/prefix)
if(EXISTS ${WORK_DIR}/prefix)
  message(FATAL_ERROR "something was installed in ${WORK_DIR}/prefix")
endif()
