#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// The members of the messages that the node reads and writes, as rosidl generates them.
namespace std_msgs::msg {
struct Header {
  std::uint64_t stamp = 0;
  std::string frame_id;
};
}  // namespace std_msgs::msg

namespace geometry_msgs::msg {
struct PoseWithCovariance {
  struct {
    struct {
      double x = 0, y = 0, z = 0;
    } position;
    struct {
      double x = 0, y = 0, z = 0, w = 1;
    } orientation;
  } pose;
  std::array<double, 36> covariance{};
};
}  // namespace geometry_msgs::msg

namespace sensor_msgs::msg {
struct PointField {
  static constexpr std::uint8_t FLOAT32 = 7, FLOAT64 = 8;
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
};
struct PointCloud2 {
  using ConstSharedPtr = std::shared_ptr<const PointCloud2>;
  std_msgs::msg::Header header;
  std::uint32_t height = 0, width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0, row_step = 0;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
};
}  // namespace sensor_msgs::msg
