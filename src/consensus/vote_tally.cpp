#include "consensus/vote_tally.hpp"

#include <algorithm>

namespace gmcr {
namespace {

std::size_t num_levels(Index num_correspondences) {
  return Levels::of(static_cast<std::uint64_t>(num_correspondences) + 1) + 1;
}

template <typename T>
void add_each(std::vector<T>& sums, const std::vector<T>& terms) {
  std::transform(sums.begin(), sums.end(), terms.begin(), sums.begin(), std::plus<>());
}

/// Largest m such that the amounts of the levels that reach m add up to m times the unit.
/// @param amounts  one a level.
template <typename T>
double most_reached(const T* amounts, std::size_t count, double unit) {
  double most = 0;
  std::uint64_t sum = 0;
  for (std::size_t level = count; level-- > 0;) {
    sum += amounts[level];
    most = std::max(
        most, std::min(static_cast<double>(Levels::top(level)), static_cast<double>(sum) / unit));
  }
  return most;
}

}  // namespace

VoteTally::VoteTally(Index num_correspondences, Index num_bins, bool weighted)
    : num_levels_(num_levels(num_correspondences)),
      pairs_(static_cast<std::size_t>(num_bins)),
      product_(weighted ? pairs_.size() : 0),
      members_(pairs_.size() * num_levels_),
      evidence_(weighted ? members_.size() : 0) {}

std::size_t VoteTally::bytes_required(Index num_correspondences, Index num_bins, bool weighted) {
  const std::size_t counts = num_levels(num_correspondences) * static_cast<std::size_t>(num_bins);
  return counts * (sizeof(std::uint32_t) + (weighted ? sizeof(std::uint64_t) : 0));
}

void VoteTally::add(const VoteTally& other) {
  add_each(pairs_, other.pairs_);
  add_each(product_, other.product_);
  add_each(members_, other.members_);
  add_each(evidence_, other.evidence_);
}

void VoteTally::read(Index bin, ScaleVotes& votes) const {
  const auto b = static_cast<std::size_t>(bin);
  votes.pairs[b] = static_cast<Index>(pairs_[b] / 2);
  votes.max_members[b] = most_reached(&members_[b * num_levels_], num_levels_, 1);
  if (evidence_.empty()) {
    votes.evidence[b] = static_cast<double>(votes.pairs[b]);
    votes.max_evidence[b] = votes.max_members[b];
    return;
  }
  votes.evidence[b] = static_cast<double>(product_[b]) / (2.0 * RunWeights::kOne);
  votes.max_evidence[b] =
      std::min(votes.max_members[b],
               most_reached(&evidence_[b * num_levels_], num_levels_, RunWeights::kOne));
}

}  // namespace gmcr
