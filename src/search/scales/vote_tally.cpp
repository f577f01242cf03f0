#include "search/scales/vote_tally.hpp"

#include <algorithm>

namespace gmcr::search {
namespace {

template <typename T>
void add_each(std::vector<T>& sums, const std::vector<T>& terms) {
  std::transform(terms.begin(), terms.end(), sums.begin(), sums.begin(), std::plus<>());
}

/// Largest m such that the amounts of the levels that reach m add up to m times the unit.
/// @param amounts  level-major.
template <typename T>
double most_reached(const std::vector<T>& amounts, std::size_t num_bins, std::size_t bin,
                    double unit) {
  double most = 0;
  std::uint64_t sum = 0;
  for (std::size_t level = amounts.size() / num_bins; level-- > 0;) {
    sum += amounts[level * num_bins + bin];
    most = std::max(most, std::min(static_cast<double>(LogLevels::top(level)),
                                   static_cast<double>(sum) / unit));
  }
  return most;
}

}  // namespace

VoteTally::VoteTally(Index num_bins, bool weighted)
    : num_bins_(static_cast<std::size_t>(num_bins)),
      weighted_(weighted),
      pairs_(num_bins_),
      product_(weighted ? num_bins_ : 0) {}

std::size_t VoteTally::bytes_required(Index num_correspondences, Index num_bins, bool weighted) {
  const std::size_t num_levels =
      LogLevels::of(static_cast<std::uint64_t>(num_correspondences) + 1) + 1;
  const std::size_t counts = 2 * num_levels * static_cast<std::size_t>(num_bins);  // as they grow
  return counts * (sizeof(std::uint32_t) + (weighted ? sizeof(std::uint64_t) : 0));
}

void VoteTally::grow(std::size_t num_levels) {
  num_levels_ = num_levels;
  members_.resize(num_levels * num_bins_);
  if (weighted_) evidence_.resize(num_levels * num_bins_);
}

void VoteTally::add(const VoteTally& other) {
  if (other.num_levels_ > num_levels_) grow(other.num_levels_);
  add_each(pairs_, other.pairs_);
  add_each(product_, other.product_);
  add_each(members_, other.members_);
  add_each(evidence_, other.evidence_);
}

void VoteTally::read(Index bin, ScaleVotes& votes) const {
  const auto b = static_cast<std::size_t>(bin);
  votes.pairs[b] = static_cast<Index>(pairs_[b] / 2);
  // L5: m members need m correspondences that agree with m - 1 others each
  votes.max_members[b] = most_reached(members_, num_bins_, b, 1);
  if (!weighted_) {
    votes.evidence[b] = static_cast<double>(votes.pairs[b]);
    votes.max_evidence[b] = votes.max_members[b];
    return;
  }
  votes.evidence[b] = static_cast<double>(product_[b]) / (2.0 * BinGroupWeights::kOne);
  votes.max_evidence[b] =
      std::min(votes.max_members[b], most_reached(evidence_, num_bins_, b, BinGroupWeights::kOne));
}

}  // namespace gmcr::search
