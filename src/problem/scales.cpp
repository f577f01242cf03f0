#include "problem/scales.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gmcr::problem {
namespace {

constexpr double kSizeFactor = 20;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median distance of the points from their median point.
double median_radius(const PointsRef& points) {
  if (points.cols() == 0) return 0;
  Eigen::Vector3d centre;
  for (Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd row = points.row(axis);
    centre[axis] = median({row.begin(), row.end()});
  }
  const Eigen::RowVectorXd distances = (points.colwise() - centre).colwise().norm();
  return median({distances.begin(), distances.end()});
}

double ratio_of(double source, double target) {
  return source > 0 && target > 0 ? target / source : 1;
}

}  // namespace

double typical_scale(const PointsRef& source, const PointsRef& target) {
  return ratio_of(median_radius(source), median_radius(target));
}

ScaleBuckets scale_buckets_of(const Options& options, const PointsRef& source,
                              const PointsRef& target) {
  const double middle =
      options.scale_mode == ScaleMode::Known ? options.scale : typical_scale(source, target);
  return ScaleBuckets(std::isnormal(middle) ? middle : 1);
}

ScaleRange default_scale_range(const Correspondences& correspondences) {
  // the median withstands a few points far out; the mean square sees a far minority of both clouds
  const double by_norm = ratio_of(correspondences.source.norm(), correspondences.target.norm());
  const double by_median = typical_scale(correspondences.source, correspondences.target);
  return {std::min(by_norm, by_median) / kSizeFactor, std::max(by_norm, by_median) * kSizeFactor};
}

ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(default_scale_range(correspondences));
}

}  // namespace gmcr::problem
