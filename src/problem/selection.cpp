#include "problem/selection.hpp"

#include <algorithm>
#include <numeric>

namespace gmcr::problem {

std::uint64_t mixed(std::uint64_t k) {
  // SplitMix64 (Steele et al. 2014)
  std::uint64_t z = (k + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

std::vector<Index> stratified_selection(Index n, Index count) {
  std::vector<Index> selected(static_cast<std::size_t>(std::min(n, count)));
  if (count >= n) {
    std::iota(selected.begin(), selected.end(), Index{0});
    return selected;
  }
  for (Index k = 0; k < count; ++k) {
    const Index begin = k * n / count, end = (k + 1) * n / count;
    const auto place =
        mixed(static_cast<std::uint64_t>(k)) % static_cast<std::uint64_t>(end - begin);
    selected[static_cast<std::size_t>(k)] = begin + static_cast<Index>(place);
  }
  return selected;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Eigen::Vector3d median_point(const PointsRef& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  if (points.cols() == 0) return centre;
  for (Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd row = points.row(axis);
    centre[axis] = median({row.begin(), row.end()});
  }
  return centre;
}

Eigen::Vector3d middle_of(const PointsRef& points) {
  constexpr Index kEnough = 1023;
  if (points.cols() <= kEnough) return median_point(points);
  return median_point(points(Eigen::all, stratified_selection(points.cols(), kEnough)));
}

}  // namespace gmcr::problem
