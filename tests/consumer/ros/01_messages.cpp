// Messages as sensors send them become points, what is not understood is refused, and a result
// fills a message.
#include <cstring>
#include <gmcr_ros/convert.hpp>
#include <iostream>
#include <limits>
#include <sensor_msgs/msg/point_cloud2.hpp>

#include "gmcr_ros/msg/registration.hpp"

namespace {

using sensor_msgs::msg::PointCloud2;
using sensor_msgs::msg::PointField;

int num_failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "not so: " << what << '\n';
  ++num_failures;
}

/// Intensity, then x, y, z as `Scalar`: (1, 2, 3), one that is not finite, (4, 5, 6).
template <class Scalar>
PointCloud2 cloud_of(std::uint8_t type) {
  PointCloud2 cloud;
  cloud.fields = {{"intensity", 0, PointField::FLOAT32, 1},
                  {"x", 4, type, 1},
                  {"y", 4 + sizeof(Scalar), type, 1},
                  {"z", 4 + 2 * sizeof(Scalar), type, 1}};
  cloud.point_step = 6 + 3 * sizeof(Scalar);
  cloud.width = 3;
  cloud.height = 1;
  cloud.row_step = 3 * cloud.point_step;
  cloud.data.resize(cloud.row_step);
  const Scalar points[3][3] = {
      {1, 2, 3}, {std::numeric_limits<Scalar>::quiet_NaN(), 0, 0}, {4, 5, 6}};
  for (std::size_t i = 0; i < 3; ++i) {
    std::memcpy(cloud.data.data() + i * cloud.point_step + 4, points[i], sizeof points[i]);
  }
  return cloud;
}

bool is_refused(const PointCloud2& cloud) {
  try {
    gmcr_ros::points_of(cloud);
  } catch (const std::invalid_argument&) {
    return true;
  }
  return false;
}

void check_points() {
  const gmcr::Points expected = (gmcr::Points(3, 2) << 1, 4, 2, 5, 3, 6).finished();
  const PointCloud2 good = cloud_of<float>(PointField::FLOAT32);
  expect(gmcr_ros::points_of(good) == expected, "float32 is read");
  expect(gmcr_ros::points_of(cloud_of<double>(PointField::FLOAT64)) == expected, "float64 is read");
  PointCloud2 empty = good;
  empty.width = empty.row_step = 0;
  empty.data.clear();
  expect(gmcr_ros::points_of(empty).cols() == 0, "an empty cloud is empty");

  PointCloud2 bad = good;
  bad.fields.pop_back();
  expect(is_refused(bad), "a cloud without z is refused");
  bad = good;
  bad.fields[2].offset += 4;
  expect(is_refused(bad), "x, y and z apart are refused");
  bad = good;
  bad.fields[1].datatype = 4;
  expect(is_refused(bad), "integers are refused");
  bad = good;
  bad.is_bigendian = !bad.is_bigendian;
  expect(is_refused(bad), "another byte order is refused");
  bad = good;
  bad.data.pop_back();
  expect(is_refused(bad), "a cut cloud is refused");
  bad = good;
  bad.point_step = 8;
  expect(is_refused(bad), "a step that holds no point is refused");
  bad = good;
  bad.height = 2;
  bad.row_step += 1;
  expect(is_refused(bad), "padded rows are refused");
}

void check_result() {
  gmcr::CloudResult result;
  result.registration.status = gmcr::Status::Ok;
  result.registration.target_from_source.translation = {1, 2, 3};
  result.registration.covariance.emplace();
  result.registration.covariance->matrix =
      Eigen::VectorXd::LinSpaced(6, 1, 6).asDiagonal();  // rotation, then translation
  result.verdict = gmcr::Verdict::Doubtful;
  result.fitness = 0.5;
  gmcr_ros::msg::Registration message;
  gmcr_ros::fill(result, message);
  expect(message.status == "ok" && message.verdict == "doubtful" && message.fitness == 0.5,
         "words");
  expect(message.pose.pose.position.z == 3 && message.pose.pose.orientation.w == 1, "pose");
  expect(message.pose.covariance[0] > 3 && message.pose.covariance[35] == 3, "translation first");
}

}  // namespace

int main() {
  check_points();
  check_result();
  return num_failures;
}
