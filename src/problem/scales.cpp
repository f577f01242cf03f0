#include "problem/scales.hpp"

#include <algorithm>
#include <cmath>

#include "problem/selection.hpp"

namespace gmcr::problem {
namespace {

constexpr double kSizeFactor = 20;

/// Median distance of the points from their median point, of an even selection of very many.
double median_radius(const PointsRef& points) {
  constexpr Index kEnough = 4096;
  if (points.cols() == 0) return 0;
  if (points.cols() > kEnough) {
    return median_radius(points(Eigen::all, stratified_selection(points.cols(), kEnough)));
  }
  const Eigen::RowVectorXd distances = (points.colwise() - median_point(points)).colwise().norm();
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
  constexpr double kMostApart = 1e4;  // a point farther out than any scene is none of it
  const double by_median = typical_scale(correspondences.source, correspondences.target);
  const double by_norm =
      std::clamp(ratio_of(correspondences.source.norm(), correspondences.target.norm()),
                 by_median / kMostApart, by_median * kMostApart);
  const auto within = [](double scale) {
    return std::clamp(scale, kLeastMagnitude, kLargestMagnitude);
  };
  return {within(std::min(by_norm, by_median) / kSizeFactor),
          within(std::max(by_norm, by_median) * kSizeFactor)};
}

ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(default_scale_range(correspondences));
}

}  // namespace gmcr::problem
