# `cmake --install`, find_package(gmcr) and pkg-config. The components: `library` (shared libraries), `development`
# (headers, static libraries, what CMake and pkg-config read), `tool`.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gmcr)
get_property(libraries GLOBAL PROPERTY GMCR_LIBRARIES)
install(TARGETS ${libraries} EXPORT gmcr-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library)
install(EXPORT gmcr-targets NAMESPACE gmcr:: DESTINATION ${package_dir} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ ${PROJECT_BINARY_DIR}/include/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gmcr-config.cmake.in
  ${PROJECT_BINARY_DIR}/gmcr-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gmcr-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gmcr-config.cmake
              ${PROJECT_BINARY_DIR}/gmcr-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/gmcr-dependencies.cmake
        DESTINATION ${package_dir} COMPONENT development)

# the notices that whoever passes the library or the tool on passes on too, each in the folder of its Debian package
foreach(notices IN ITEMS library:libgmcr${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} development:libgmcr-dev
        tool:gmcr)
  string(REPLACE ":" ";" notices ${notices})
  list(GET notices 0 component)
  list(GET notices 1 folder)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/THIRD_PARTY.md
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${folder} COMPONENT ${component})
endforeach()

# gmcr_pkg_config(NAME DESCRIPTION [REQUIRES packages...] [PRIVATE packages...] [LIBS flags...]): NAME.pc. What is
# private matters to whoever links a static library, so there it is required like the rest.
function(gmcr_pkg_config name description)
  cmake_parse_arguments(arg "" "" "REQUIRES;PRIVATE;LIBS" ${ARGN})
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND arg_REQUIRES ${arg_PRIVATE})
    set(arg_PRIVATE "")
  endif()
  list(JOIN arg_REQUIRES ", " requires)
  list(JOIN arg_PRIVATE ", " requires_private)
  list(JOIN arg_LIBS " " libs)
  string(REPLACE "-" "_" library ${name})
  # from where the file is, so that the whole tree may be moved
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/gmcr.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()

gmcr_pkg_config(gmcr "transforms from putative correspondences, with a certificate"
  REQUIRES eigen3 PRIVATE tbb libhwy)
gmcr_pkg_config(gmcr-frontend "transforms from raw clouds" REQUIRES gmcr)
gmcr_pkg_config(gmcr-io "readers and writers of clouds and matches" REQUIRES gmcr PRIVATE liblzf)
gmcr_pkg_config(gmcr-report "results as JSON and in words" REQUIRES gmcr gmcr-frontend)
gmcr_pkg_config(gmcr-synthetic "registration problems with a known answer" REQUIRES gmcr)
get_property(cxx_runtime GLOBAL PROPERTY GMCR_CXX_RUNTIME)
list(TRANSFORM cxx_runtime PREPEND -l)
if(BUILD_SHARED_LIBS)
  set(cxx_runtime "")
endif()
gmcr_pkg_config(gmcr-c "the interface for C" PRIVATE gmcr-report LIBS ${cxx_runtime})
