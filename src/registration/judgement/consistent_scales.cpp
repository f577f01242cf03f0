#include "registration/judgement/consistent_scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "parallel/parallel_for.hpp"

namespace gmcr::registration {
namespace {

constexpr double kRounding = 1 + 1e-9;

/// Inliers by ascending slack eps - r.
struct SortedInliers {
  Eigen::Matrix3Xd source, target;
  Eigen::ArrayXd bounds, slacks;
  Eigen::ArrayXd radius;  ///< no source is farther away from that of i than radius_i

  Index size() const { return source.cols(); }
};

SortedInliers sort_by_slack(const geometry::CorrespondenceArrays& inliers,
                            const Eigen::ArrayXd& residuals) {
  const Eigen::ArrayXd slacks = (inliers.bounds - residuals).max(0);
  std::vector<Index> order(static_cast<std::size_t>(inliers.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return slacks[i] < slacks[j]; });
  SortedInliers sorted;
  sorted.source = inliers.source(order, Eigen::all).transpose();
  sorted.target = inliers.target(order, Eigen::all).transpose();
  sorted.bounds = inliers.bounds(order);
  sorted.slacks = slacks(order);
  if (sorted.size() == 0) return sorted;
  const Eigen::Vector3d centre = sorted.source.rowwise().mean();
  sorted.radius = (sorted.source.colwise() - centre).colwise().norm();
  sorted.radius += sorted.radius.maxCoeff();
  return sorted;
}

/// Intersects `range` with the intervals of i and each later inlier.
ScaleRange intersect_row(const SortedInliers& inliers, Index i, double scale, ScaleRange range) {
  for (Index j = i + 1; j < inliers.size(); ++j) {
    const double width = kRounding * std::max(scale - range.min, range.max - scale);
    const double room = inliers.slacks[i] + inliers.slacks[j];
    if (room > width * inliers.radius[i]) break;  // and so for all later ones
    const double aa = (inliers.source.col(j) - inliers.source.col(i)).squaredNorm();
    if (aa == 0 || room * room > width * width * aa) continue;
    const double a = std::sqrt(aa), b = (inliers.target.col(j) - inliers.target.col(i)).norm();
    const double e = inliers.bounds[i] + inliers.bounds[j];
    // a pair of inliers holds the scale, to rounding
    // L1: (|bbar| - e) / |abar| <= s <= (|bbar| + e) / |abar|
    range.min = std::max(range.min, std::min((b - e) / a, scale));
    range.max = std::min(range.max, std::max((b + e) / a, scale));
  }
  return range;
}

}  // namespace

ScaleRange consistent_scales(const geometry::CorrespondenceArrays& inliers,
                             const Eigen::ArrayXd& residuals, double scale, int num_threads,
                             const parallel::Deadline& deadline) {
  constexpr Index kFirstRows = 32, kRowsPerChunk = 64;
  const SortedInliers sorted = sort_by_slack(inliers, residuals);
  ScaleRange range{0, std::numeric_limits<double>::infinity()};
  const Index num_first = std::min(kFirstRows, sorted.size());
  for (Index i = 0; i < num_first && !deadline.expired(); ++i) {
    range = intersect_row(sorted, i, scale, range);
  }
  const Index num_rest = sorted.size() - num_first;
  std::vector<ScaleRange> chunks(
      static_cast<std::size_t>((num_rest + kRowsPerChunk - 1) / kRowsPerChunk), range);
  parallel::parallel_for(num_rest, kRowsPerChunk, num_threads, [&](Index begin, Index end) {
    ScaleRange& chunk = chunks[static_cast<std::size_t>(begin / kRowsPerChunk)];
    for (Index i = begin; i < end && !deadline.expired(); ++i) {
      chunk = intersect_row(sorted, num_first + i, scale, chunk);
    }
  });
  for (const ScaleRange& chunk : chunks) {
    range = {std::max(range.min, chunk.min), std::min(range.max, chunk.max)};
  }
  return range;
}

}  // namespace gmcr::registration
