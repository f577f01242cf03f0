#include "consensus/distinct_evidence.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace gmcr {
namespace {

/// Calls visit(i, j, max_scale) for each pair whose target points are within kReach (eps_i + eps_j)
/// until it returns false.
template <typename Visit>
bool for_each_partner(const Correspondences& c, const Visit& visit) {
  if (c.size() == 0) return true;
  // sweeps along the axis on which the targets are spread widest
  Index axis = 0;
  (c.target.rowwise().maxCoeff() - c.target.rowwise().minCoeff()).maxCoeff(&axis);
  std::vector<Index> order(static_cast<std::size_t>(c.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return c.target(axis, i) < c.target(axis, j); });
  constexpr double kReach = DistinctEvidence::kReach;
  const double max_bound = c.bounds.maxCoeff();
  for (std::size_t p = 0; p < order.size(); ++p) {
    const Index i = order[p];
    for (std::size_t q = p + 1; q < order.size(); ++q) {
      const Index j = order[q];
      if (c.target(axis, j) - c.target(axis, i) > kReach * (c.bounds[i] + max_bound)) break;
      const double bound = kReach * (c.bounds[i] + c.bounds[j]);
      if ((c.target.col(j) - c.target.col(i)).squaredNorm() > bound * bound) continue;
      const double length = (c.source.col(j) - c.source.col(i)).norm();
      const double max_scale =
          length > 0 ? bound / length : std::numeric_limits<double>::infinity();
      if (!visit(i, j, max_scale)) return false;
    }
  }
  return true;
}

}  // namespace

DistinctEvidence::DistinctEvidence(const Correspondences& correspondences, std::size_t max_bytes) {
  const auto n = static_cast<std::size_t>(correspondences.size());
  const std::size_t max_entries = max_bytes / sizeof(double);
  std::vector<std::size_t> count(n + 1, 0);
  std::size_t total = 0;
  complete_ = for_each_partner(correspondences, [&](Index i, Index j, double) {
    ++count[static_cast<std::size_t>(i)];
    ++count[static_cast<std::size_t>(j)];
    total += 2;
    return total <= max_entries;
  });
  if (!complete_) return;

  first_.assign(n + 1, 0);
  std::partial_sum(count.begin(), count.end() - 1, first_.begin() + 1);
  max_scales_.resize(total);
  std::vector<std::size_t> next(first_.begin(), first_.end());
  for_each_partner(correspondences, [&](Index i, Index j, double max_scale) {
    max_scales_[next[static_cast<std::size_t>(i)]++] = max_scale;
    max_scales_[next[static_cast<std::size_t>(j)]++] = max_scale;
    return true;
  });
  for (std::size_t i = 0; i < n; ++i) {
    std::sort(max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
              max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]), std::greater<>());
  }
}

double DistinctEvidence::weight(Index i, double scale) const {
  if (!complete_) return 1;
  const auto begin =
      max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[static_cast<std::size_t>(i)]);
  const auto end =
      max_scales_.begin() + static_cast<std::ptrdiff_t>(first_[static_cast<std::size_t>(i) + 1]);
  const auto partners =
      std::partition_point(begin, end, [&](double max_scale) { return scale <= max_scale; }) -
      begin;
  return 1.0 / (1.0 + static_cast<double>(partners));
}

}  // namespace gmcr
