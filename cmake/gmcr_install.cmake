# `cmake --install` and find_package(gmcr) for users. Exports the core, the front end, files and
# reports.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gmcr)
install(TARGETS gmcr gmcr_frontend gmcr_io gmcr_report EXPORT gmcr-targets)
install(EXPORT gmcr-targets NAMESPACE gmcr:: DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/gmcr ${PROJECT_BINARY_DIR}/include/gmcr
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        PATTERN synthetic.hpp EXCLUDE)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gmcr-config.cmake.in
  ${PROJECT_BINARY_DIR}/gmcr-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gmcr-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gmcr-config.cmake
              ${PROJECT_BINARY_DIR}/gmcr-config-version.cmake
        DESTINATION ${package_dir})
