#pragma once
#include <sensor_msgs/msg/point_cloud2.hpp>

namespace gmcr_ros::msg {
struct Registration {
  std_msgs::msg::Header header;
  std::string source_frame_id;
  geometry_msgs::msg::PoseWithCovariance pose;
  std::string status, verdict, verdict_reason;
  double fitness = 0;
};
}  // namespace gmcr_ros::msg
