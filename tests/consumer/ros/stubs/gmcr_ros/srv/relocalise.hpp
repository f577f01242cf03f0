#pragma once
#include "gmcr_ros/msg/registration.hpp"

namespace gmcr_ros::srv {
struct Relocalise {
  struct Request {
    sensor_msgs::msg::PointCloud2 scan;
  };
  struct Response {
    gmcr_ros::msg::Registration registration;
  };
};
}  // namespace gmcr_ros::srv
