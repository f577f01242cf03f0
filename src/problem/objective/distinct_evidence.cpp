#include "problem/objective/distinct_evidence.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "geometry/close_pairs.hpp"

namespace gmcr::problem {
namespace {

/// Calls visit(i, j, max_scale) for the pairs that are copies at scales up to max_scale.
bool for_each_copy(const PointsRef& source, const PointsRef& target, const Eigen::ArrayXd& radii,
                   const std::function<bool(Index i, Index j, double max_scale)>& visit) {
  return geometry::for_each_close_pair(target, radii, [&](Index i, Index j, double radius) {
    const double length = (source.col(j) - source.col(i)).norm();
    return visit(i, j, length > 0 ? radius / length : std::numeric_limits<double>::infinity());
  });
}

}  // namespace

DistinctEvidence::DistinctEvidence(const PointsRef& source, const PointsRef& target,
                                   const Eigen::ArrayXd& bounds, std::size_t max_bytes,
                                   const ScaleBuckets& buckets, const ScaleRange& scales,
                                   const parallel::Deadline& deadline)
    : buckets_(buckets) {
  const ScaleRange centres{buckets.centre_of(scales.min), buckets.centre_of(scales.max)};
  const Eigen::ArrayXd radii = kCopyRadius * bounds;
  const auto n = static_cast<std::size_t>(source.cols());
  const auto at = [](Index i) { return static_cast<std::size_t>(i); };
  const std::size_t max_entries = max_bytes / sizeof(double);
  constexpr std::size_t kBetweenLooks = std::size_t{1} << 18;  // at the clock
  std::size_t num_near = 0;
  always_.assign(n, 0);
  first_.assign(n + 1, 0);
  complete_ = for_each_copy(source, target, radii, [&](Index i, Index j, double max_scale) {
    num_near += 2;
    if (max_scale >= centres.max) {
      ++always_[at(i)];
      ++always_[at(j)];
      has_copies_ = true;
    } else if (max_scale >= centres.min) {
      ++first_[at(i) + 1];
      ++first_[at(j) + 1];
    }
    return num_near <= max_entries && (num_near % kBetweenLooks != 0 || !deadline.expired());
  });
  if (!complete_) has_copies_ = false;
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  if (!complete_ || first_.back() == 0) return;

  has_copies_ = true;
  max_scales_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end());
  for_each_copy(source, target, radii, [&](Index i, Index j, double max_scale) {
    if (max_scale < centres.max && max_scale >= centres.min) {
      max_scales_[next[at(i)]++] = max_scale;
      max_scales_[next[at(j)]++] = max_scale;
    }
    return true;
  });
  for (std::size_t i = 0; i < n; ++i) {
    std::sort(max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
              max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]), std::greater<>());
  }
}

double DistinctEvidence::weight(Index i, double scale) const {
  if (!complete_) return 1;
  const double centre = buckets_.centre_of(scale);
  const auto place = static_cast<std::size_t>(i);
  const auto begin = max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[place]);
  const auto end = max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[place + 1]);
  const auto listed =
      std::partition_point(begin, end, [&](double max_scale) { return centre <= max_scale; }) -
      begin;
  // L6: w_i(s) = 1 / (1 + number of copies at s)
  return 1.0 / (1.0 + static_cast<double>(always_[place] + listed));
}

}  // namespace gmcr::problem
