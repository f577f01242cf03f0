# `cmake --install` and find_package(gmcr) for users.
include(CMakePackageConfigHelpers)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/gmcr ${PROJECT_BINARY_DIR}/include/gmcr
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
