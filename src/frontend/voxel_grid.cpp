#include "frontend/voxel_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmcr {
namespace {

struct KeyedPoint {
  std::int64_t cell;
  Index point;
};

/// Cells along each axis.
/// @throws std::invalid_argument where their product overflows 63 bits.
Eigen::Vector3d count_cells(const Eigen::Vector3d& extent, double voxel_size) {
  const Eigen::Vector3d cells = (extent / voxel_size).array().floor() + 1;
  constexpr double kLargest = 9.2e18;
  // each axis too: a product of infinity and the like must not pass
  if (!(cells.maxCoeff() < kLargest && cells.prod() < kLargest)) {
    throw std::invalid_argument("voxel_size: " + std::to_string(voxel_size) +
                                " is too small for a cloud that spans " +
                                std::to_string(extent.maxCoeff()));
  }
  return cells;
}

std::vector<KeyedPoint> sort_by_cell(const PointsRef& points, const Eigen::Vector3d& origin,
                                     double voxel_size, const Eigen::Vector3d& cells) {
  const auto num_y = static_cast<std::int64_t>(cells.y());
  const auto num_z = static_cast<std::int64_t>(cells.z());
  std::vector<KeyedPoint> keyed(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d cell = ((points.col(i) - origin) / voxel_size).array().floor();
    const auto x = static_cast<std::int64_t>(cell.x());
    const auto y = static_cast<std::int64_t>(cell.y());
    const auto z = static_cast<std::int64_t>(cell.z());
    keyed[static_cast<std::size_t>(i)] = {(x * num_y + y) * num_z + z, i};
  }
  std::sort(keyed.begin(), keyed.end(), [](const KeyedPoint& a, const KeyedPoint& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.point < b.point;
  });
  return keyed;
}

}  // namespace

Points voxel_grid(const PointsRef& points, double voxel_size) {
  if (points.cols() == 0) return Points(3, 0);
  const Eigen::Vector3d origin = points.rowwise().minCoeff();
  const Eigen::Vector3d extent = points.rowwise().maxCoeff() - origin;
  const auto keyed = sort_by_cell(points, origin, voxel_size, count_cells(extent, voxel_size));

  Points means(3, points.cols());
  Index num_means = 0;
  for (auto first = keyed.begin(); first != keyed.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // relative to the origin: no loss far from 0
    auto last = first;
    for (; last != keyed.end() && last->cell == first->cell; ++last) {
      sum += points.col(last->point) - origin;
    }
    means.col(num_means++) = origin + sum / static_cast<double>(last - first);
    first = last;
  }
  means.conservativeResize(Eigen::NoChange, num_means);
  return means;
}

}  // namespace gmcr
