#include "frontend/points/extent.hpp"

#include <algorithm>
#include <vector>

namespace gmcr::frontend {
namespace {

double quantile(std::vector<double>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace

double robust_extent(const PointsRef& points) {
  std::vector<double> values(static_cast<std::size_t>(points.cols()));
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::copy(points.row(axis).begin(), points.row(axis).end(), values.begin());
    median[axis] = quantile(values, 0.5);
  }
  for (Index i = 0; i < points.cols(); ++i) {
    values[static_cast<std::size_t>(i)] = (points.col(i) - median).norm();
  }
  return 2 * quantile(values, 0.9);
}

}  // namespace gmcr::frontend
