# Settings that every target of the project shares.
include(CheckCXXCompilerFlag)

# gmcr_add_flags(VARIABLE flags...): appends to the list those that the compiler knows.
function(gmcr_add_flags variable)
  foreach(flag IN LISTS ARGN)
    # compilers are silent on a -Wno-x that they do not know, until they have something to say
    string(REGEX REPLACE "^-Wno-" "-W" asked ${flag})
    string(MAKE_C_IDENTIFIER "GMCR_HAS${asked}" known)
    check_cxx_compiler_flag(${asked} ${known})
    if(${known})
      list(APPEND ${variable} ${flag})
    endif()
  endforeach()
  set(${variable} ${${variable}} PARENT_SCOPE)
endfunction()

include(CheckLinkerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)  # position-independent programs too

option(GMCR_HARDENING "Compile and link what users get with the hardening flags that the compiler knows" ON)
set(gmcr_hardening_compile "")
set(gmcr_hardening_link "")
# sanitizers bring their own, and fortified functions go past what they watch
if(GMCR_HARDENING AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize|--coverage")
  gmcr_add_flags(gmcr_hardening_compile -fstack-protector-strong -fstack-clash-protection -fcf-protection)
  foreach(flag IN ITEMS -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)  # which needs an optimiser
    list(APPEND gmcr_hardening_compile $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:${flag}>)
  endforeach()
  foreach(word IN ITEMS relro now noexecstack)
    check_linker_flag(CXX "LINKER:-z,${word}" GMCR_HAS_Z_${word})
    if(GMCR_HAS_Z_${word})
      list(APPEND gmcr_hardening_link "LINKER:-z,${word}")
    endif()
  endforeach()
endif()

# gmcr_harden(TARGET): the flags above, for what users get: the library, the tool and the Python module.
function(gmcr_harden target)
  target_compile_options(${target} PRIVATE ${gmcr_hardening_compile})
  target_link_options(${target} PRIVATE ${gmcr_hardening_link})
endfunction()

# The same bits on every machine: no fused multiply-add that the compiler picks by itself, nor Eigen where all processors of a
# kind have one.
set(gmcr_flags "")
gmcr_add_flags(gmcr_flags -Wall -Wextra -Wshadow -Wpedantic -ffp-contract=off
  # false alarms of g++ 12 inside Eigen, and on "literal" + std::string
  -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict -Wno-stringop-overread
  # meant, in inner loops
  -Wno-bitwise-instead-of-logical)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  gmcr_add_flags(gmcr_flags -U__ARM_FEATURE_FMA)
endif()
if(GMCR_WARNINGS_AS_ERRORS)
  gmcr_add_flags(gmcr_flags -Werror)
endif()

# What is not marked GMCR_PUBLIC is hidden: a shared library offers what the public headers declare.
function(gmcr_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE ${gmcr_flags})
endfunction()

# gmcr_precompile(TARGET OWNER [headers...]): headers that most files include, parsed once and not in each of them, by
# the OWNER (then with the headers) for all targets of the same flags. Files include what they use all the same:
# tools/lint reads them without.
function(gmcr_precompile target owner)
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <functional>
      <limits> <numeric> <optional> <span> <stdexcept> <string> <utility> <vector> ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

option(GMCR_COMPILE_TOGETHER "Compile files of a target together, which takes less time for all and more for one" ON)

# gmcr_compile_together(TARGET): its files, eight by eight (decision 50).
function(gmcr_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${GMCR_COMPILE_TOGETHER})
endfunction()

# gmcr_module(NAME SOURCES files... [LINK modules...]): a folder of the core as a library of its own, gmcr_NAME. With
# the tests all of it is linked against the modules named here and nothing else: what is not named is not found.
function(gmcr_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  set(target gmcr_${name})
  list(TRANSFORM arg_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_library(${target} STATIC ${arg_SOURCES})
  gmcr_target_defaults(${target})
  gmcr_harden(${target})
  gmcr_compile_together(${target})
  gmcr_precompile(${target} gmcr_geometry)
  target_include_directories(${target}
    PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  list(TRANSFORM arg_LINK PREPEND gmcr_)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen ${arg_LINK})
  set_property(GLOBAL APPEND PROPERTY GMCR_MODULES ${name})
  if(GMCR_BUILD_TESTS)
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/layer.cpp CONTENT "")
    add_library(${target}_layer MODULE ${CMAKE_CURRENT_BINARY_DIR}/layer.cpp)
    target_link_libraries(${target}_layer PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,${target}> -Wl,-z,defs)
  endif()
endfunction()

# gmcr_library(NAME [PUBLIC libs...] [PRIVATE libs...]): target gmcr_NAME, or gmcr for the core, alias gmcr::NAME,
# static or, with BUILD_SHARED_LIBS, shared.
function(gmcr_library name)
  cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
  if(name STREQUAL "gmcr")
    set(target gmcr)
  else()
    set(target gmcr_${name})
  endif()
  add_library(${target})
  add_library(gmcr::${name} ALIAS ${target})
  set_property(GLOBAL APPEND PROPERTY GMCR_LIBRARIES ${target})
  # no NAME_EXPORTS: static and shared libraries are made of the same objects, for the compiler cache
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} DEFINE_SYMBOL ""
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    WINDOWS_EXPORT_ALL_SYMBOLS ON)
  if(NOT WIN32 AND NOT APPLE)
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")  # where the others of them are
  endif()
  gmcr_target_defaults(${target})
  gmcr_harden(${target})
  gmcr_compile_together(${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
           $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  gmcr_export_by_script(${target})
endfunction()

# gmcr_link_private(TARGET modules...): what TARGET takes from private folders of the core. A static core has them; a
# shared one hides them, so there TARGET gets copies of its own.
function(gmcr_link_private target)
  if(BUILD_SHARED_LIBS)
    list(TRANSFORM ARGN PREPEND gmcr_ OUTPUT_VARIABLE modules)
    target_link_libraries(${target} PRIVATE ${modules})
  endif()
endfunction()

# The linker hides what the compiler leaves visible in spite of its flags: instances of templates of others.
function(gmcr_export_by_script target)
  if(BUILD_SHARED_LIBS AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(script ${PROJECT_BINARY_DIR}/exports.map)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/exports.map.in ${script} @ONLY)
    target_link_options(${target} PRIVATE -Wl,--version-script=${script} -Wl,-z,defs)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
  endif()
endfunction()
