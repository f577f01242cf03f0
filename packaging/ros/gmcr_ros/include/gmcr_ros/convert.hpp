#pragma once

#include <Eigen/Geometry>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <gmcr/frontend.hpp>
#include <gmcr/points.hpp>
#include <stdexcept>
#include <string>

/// Messages of ROS from and to what gmcr takes. Templates, so that this header needs no ROS.
namespace gmcr_ros {

/// The field `name` of a sensor_msgs/PointCloud2.
/// @throws std::invalid_argument where there is none.
template <class Cloud>
const auto& field_of(const Cloud& cloud, const std::string& name) {
  for (const auto& field : cloud.fields) {
    if (field.name == name) return field;
  }
  throw std::invalid_argument("the cloud has no field " + name);
}

/// Points of a sensor_msgs/PointCloud2 that are finite, 3 x N, metres.
/// @throws std::invalid_argument where x, y and z are not float32 or float64 side by side, the byte
///   order is not this machine's, or the data is shorter than its size says.
/// Cost O(number of points).
template <class Cloud>
gmcr::Points points_of(const Cloud& cloud) {
  const auto& x = field_of(cloud, "x");
  const bool is_double = x.datatype == x.FLOAT64;
  const std::uint32_t size = is_double ? 8 : 4;
  if (!is_double && x.datatype != x.FLOAT32) {
    throw std::invalid_argument("the field x is neither float32 nor float64");
  }
  for (const char* name : {"y", "z"}) {
    const auto& field = field_of(cloud, name);
    const std::uint32_t place = x.offset + (*name == 'y' ? 1 : 2) * size;
    if (field.datatype != x.datatype || field.offset != place) {
      throw std::invalid_argument("the fields x, y and z are not side by side");
    }
  }
  if (cloud.is_bigendian != (std::endian::native == std::endian::big)) {
    throw std::invalid_argument("the byte order of the cloud is not this machine's");
  }
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (cloud.row_step != cloud.point_step * cloud.width && cloud.height > 1) {
    throw std::invalid_argument("the rows of the cloud are padded");
  }
  if (count > 0 &&
      (cloud.point_step < x.offset + 3 * size || cloud.data.size() / cloud.point_step < count)) {
    throw std::invalid_argument("the data of the cloud is shorter than its size says");
  }
  const std::uint8_t* first = cloud.data.data() + x.offset;
  return gmcr::finite_points(
      is_double ? gmcr::points_from_strided<double>(first, count, cloud.point_step)
                : gmcr::points_from_strided<float>(first, count, cloud.point_step));
}

/// Fills a geometry_msgs/PoseWithCovariance. Only a scale of 1 can be told by it.
template <class PoseWithCovariance>
void fill_pose(const gmcr::CloudResult& result, PoseWithCovariance& message) {
  const gmcr::Similarity& pose = result.registration.target_from_source;
  const Eigen::Quaterniond rotation(pose.rotation);
  message.pose.position.x = pose.translation.x();
  message.pose.position.y = pose.translation.y();
  message.pose.position.z = pose.translation.z();
  message.pose.orientation.x = rotation.x();
  message.pose.orientation.y = rotation.y();
  message.pose.orientation.z = rotation.z();
  message.pose.orientation.w = rotation.w();
  message.covariance.fill(0);
  if (!result.registration.covariance) return;
  const Eigen::Matrix<double, 6, 6> covariance =
      gmcr::pose_graph_covariance(*result.registration.covariance, pose, gmcr::PoseGraph::Ros);
  for (std::size_t row = 0; row < 6; ++row) {
    for (std::size_t column = 0; column < 6; ++column) {
      message.covariance[6 * row + column] =
          covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    }
  }
}

/// Fills a gmcr_ros/Registration, but for its header and frames.
template <class Registration>
void fill(const gmcr::CloudResult& result, Registration& message) {
  fill_pose(result, message.pose);
  message.status = gmcr::to_string(result.registration.status);
  message.verdict = gmcr::to_string(result.verdict);
  message.verdict_reason = result.verdict_reason;
  message.fitness = result.fitness;
}

}  // namespace gmcr_ros
