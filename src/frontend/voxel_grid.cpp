#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "gmcr/frontend.hpp"

namespace gmcr {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct KeyedPoint {
  Cell cell;
  Index point;
};

/// @throws std::invalid_argument where an axis has more cells than 63 bits can number.
void require_countable(const Eigen::Vector3d& extent, double voxel_size) {
  constexpr double kMostCells = 9.2e18;
  if (extent.maxCoeff() / voxel_size < kMostCells) return;
  std::ostringstream message;
  message << "voxel_size: " << voxel_size << " is too small for a cloud that spans "
          << extent.maxCoeff();
  throw std::invalid_argument(message.str());
}

/// The cells are not numbered one by one along the three axes, so that one stray point far away
/// does not exhaust the numbers.
std::vector<KeyedPoint> sort_by_cell(const PointsRef& points, const Eigen::Vector3d& origin,
                                     double voxel_size) {
  std::vector<KeyedPoint> keyed(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d cell = ((points.col(i) - origin) / voxel_size).array().floor();
    keyed[static_cast<std::size_t>(i)] = {
        {static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()),
         static_cast<std::int64_t>(cell.z())},
        i};
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
  require_countable(extent, voxel_size);
  const auto keyed = sort_by_cell(points, origin, voxel_size);

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
