#pragma once

#include <cstddef>
#include <cstring>
#include <iterator>
#include <ranges>

#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

// Points of other libraries as `Points`; headers of these are not needed.
namespace GMCR_PUBLIC gmcr {

/// Points of a buffer whose x, y and z are three numbers one after the other, aligned or not.
/// @param data    bytes of the x of the first point; may be null where there are none.
/// @param stride  bytes from the x of a point to that of the next.
/// Cost O(count).
template <class Scalar>
Points points_from_strided(const void* data, std::size_t count,
                           std::size_t stride = 3 * sizeof(Scalar)) {
  Points points(3, static_cast<Index>(count));
  const auto* bytes = static_cast<const std::byte*>(data);
  for (Index i = 0; i < points.cols(); ++i) {
    Scalar xyz[3];
    std::memcpy(xyz, bytes + static_cast<std::size_t>(i) * stride, sizeof xyz);
    points.col(i) << static_cast<double>(xyz[0]), static_cast<double>(xyz[1]),
        static_cast<double>(xyz[2]);
  }
  return points;
}

/// A point with members x, y and z, such as those of PCL and of ROS messages.
template <class Point>
concept HasXyz = requires(const Point& point) {
  static_cast<double>(point.x);
  static_cast<double>(point.y);
  static_cast<double>(point.z);
};

/// A point of three numbers by index, such as std::array, float* and Eigen::Vector3f.
template <class Point>
concept HasThreeNumbers = !HasXyz<Point> && requires(const Point& point) {
  static_cast<double>(point[0]);
};

/// Points of a range of such points: `std::vector<std::array<float, 3>>`, `pcl::PointCloud`, the
/// `points_` of Open3D's clouds. They stay in order, and what is not finite stays too.
/// Cost O(number of points).
template <std::ranges::input_range Range>
requires HasXyz<std::ranges::range_value_t<Range>> ||
    HasThreeNumbers<std::ranges::range_value_t<Range>>
        Points points_from(const Range& range) {
  Points points(3, static_cast<Index>(std::ranges::distance(range)));
  Index i = 0;
  for (const auto& point : range) {
    if constexpr (HasXyz<std::ranges::range_value_t<Range>>) {
      points.col(i++) << static_cast<double>(point.x), static_cast<double>(point.y),
          static_cast<double>(point.z);
    } else {
      points.col(i++) << static_cast<double>(point[0]), static_cast<double>(point[1]),
          static_cast<double>(point[2]);
    }
  }
  return points;
}

/// Points of a cloud that keeps them in `points_`, as Open3D's do.
template <class Cloud>
requires requires(const Cloud& cloud) { cloud.points_.begin(); }
Points points_from(const Cloud& cloud) { return points_from(cloud.points_); }

/// The finite ones, in order: `register_clouds` takes no others, and sensors give NaN for no
/// return. Cost O(N).
inline Points finite_points(const PointsRef& points) {
  Points kept(3, points.cols());
  Index count = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (points.col(i).allFinite()) kept.col(count++) = points.col(i);
  }
  kept.conservativeResize(Eigen::NoChange, count);
  return kept;
}

}  // namespace gmcr
