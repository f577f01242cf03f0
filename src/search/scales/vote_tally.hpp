#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "search/scales/scale_votes.hpp"

namespace gmcr::search {

/// LogLevels of a number >= 1: of their own up to 127, then 64 for each doubling.
struct LogLevels {
  static std::size_t of(std::uint64_t number) {
    if (number < 128) return number;
    const int shift = std::bit_width(number) - 7;
    return static_cast<std::size_t>(64 * shift) + (number >> shift);
  }
  /// Largest number of a level.
  static std::uint64_t top(std::size_t level) {
    if (level < 128) return level;
    const std::size_t shift = level / 64 - 1;
    return ((level - 64 * shift + 1) << shift) - 1;
  }
};

/// A histogram for each bin: how many correspondences agree there with how many others, and with
/// others of what weight. 30 correspondences that agree with 7 others each add 30 to level 8. Sums
/// of whole numbers: the order of the additions does not matter.
class VoteTally {
 public:
  VoteTally(Index num_bins, bool weighted);

  /// Bytes that a tally of so many correspondences may take.
  static std::size_t bytes_required(Index num_correspondences, Index num_bins, bool weighted);

  /// Adds a correspondence of weight `own` that agrees in a bin with `pairs` others of weight
  /// `others` in sum.
  void add(Index bin, std::uint64_t pairs, std::uint64_t others, std::uint64_t own) {
    const auto b = static_cast<std::size_t>(bin);
    pairs_[b] += pairs;
    const std::size_t level = LogLevels::of(pairs + 1);
    if (level >= num_levels_) grow(level + 1);
    ++members_[level * num_bins_ + b];
    if (!weighted_) return;
    product_[b] += (others * own + BinGroupWeights::kOne - 1) / BinGroupWeights::kOne;
    // weights are at most 1, so this level is no higher
    const std::uint64_t together =
        (others + own + BinGroupWeights::kOne - 1) / BinGroupWeights::kOne;
    evidence_[LogLevels::of(together) * num_bins_ + b] += own;
  }

  void add(const VoteTally& other);

  /// The votes of a bin.
  void read(Index bin, ScaleVotes& votes) const;

 private:
  void grow(std::size_t num_levels);

  std::size_t num_bins_ = 0, num_levels_ = 0;
  bool weighted_ = false;
  std::vector<std::uint64_t> pairs_, product_;  ///< a bin, twice: a pair has two ends
  // level-major: a correspondence has similar levels in neighbouring bins
  std::vector<std::uint32_t> members_;   ///< correspondences, a level and bin
  std::vector<std::uint64_t> evidence_;  ///< weights, a level and bin; none where all are 1
};

}  // namespace gmcr::search
