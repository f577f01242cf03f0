cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK_DIR})
set(prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix} --component development)
build_and_run(${ROOT}/examples ${prefix})
build_and_run(${ROOT}/examples/c ${prefix})
build_and_run(${CMAKE_CURRENT_LIST_DIR}/ros ${prefix} -DGMCR_ROS=${ROOT}/packaging/ros/gmcr_ros)

# PCL is large and not among the packages of the tests: where it is there
find_path(pcl pcl/pcl_config.h PATH_SUFFIXES pcl-1.12 pcl-1.13 pcl-1.14 pcl-1.15)
if(pcl)
  build_and_run(${CMAKE_CURRENT_LIST_DIR}/pcl ${prefix})
else()
  message(STATUS "no test of gmcr/pcl.hpp: PCL is not installed")
endif()
compile_by_pkg_config(${ROOT}/examples/c/01_pose.c ${prefix})
