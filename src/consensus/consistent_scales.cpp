#include "consensus/consistent_scales.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

constexpr ScaleRange kAllScales{0, std::numeric_limits<double>::infinity()};

ScaleRange intersect(const ScaleRange& a, const ScaleRange& b) {
  return {std::max(a.min, b.min), std::min(a.max, b.max)};
}

/// Intersection of the intervals of i with each later correspondence.
/// @param a, b  room for N lengths.
ScaleRange intersect_row(const kernels::CorrespondenceArrays& inliers, Index i,
                         std::vector<double>& a, std::vector<double>& b) {
  kernels::pair_lengths(inliers, i, a, b);
  ScaleRange range = kAllScales;
  for (Index j = i + 1; j < inliers.size(); ++j) {
    const auto k = static_cast<std::size_t>(j - i - 1);
    if (a[k] == 0) continue;  // agrees at every scale or at none
    const double e = inliers.bounds[i] + inliers.bounds[j];
    range = intersect(range, {(b[k] - e) / a[k], (b[k] + e) / a[k]});
  }
  return range;
}

}  // namespace

ScaleRange consistent_scales(const kernels::CorrespondenceArrays& inliers, double scale,
                             int num_threads, const Deadline& deadline) {
  constexpr Index kRowsPerChunk = 16;
  const Index n = inliers.size();
  std::vector<ScaleRange> chunks(static_cast<std::size_t>((n + kRowsPerChunk - 1) / kRowsPerChunk),
                                 kAllScales);
  parallel_for(n, kRowsPerChunk, num_threads, [&](Index begin, Index end) {
    if (deadline.expired()) return;
    ScaleRange& range = chunks[static_cast<std::size_t>(begin / kRowsPerChunk)];
    std::vector<double> a(static_cast<std::size_t>(n)), b(static_cast<std::size_t>(n));
    for (Index i = begin; i < end; ++i) range = intersect(range, intersect_row(inliers, i, a, b));
  });
  ScaleRange range = kAllScales;
  for (const ScaleRange& chunk : chunks) range = intersect(range, chunk);
  return {std::min(range.min, scale), std::max(range.max, scale)};
}

}  // namespace gmcr
