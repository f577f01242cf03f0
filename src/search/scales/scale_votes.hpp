#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/correspondence_arrays.hpp"
#include "parallel/deadline.hpp"
#include "search/scales/scale_bins.hpp"

namespace gmcr::search {

/// Weights of the correspondences, taken as constant over groups of neighbouring bins, in whole
/// numbers of kOne-th parts, rounded up: sums of them are the same in any order.
class BinGroupWeights {
 public:
  static constexpr std::uint32_t kOne = std::uint32_t{1} << 20;

  /// Every weight 1.
  explicit BinGroupWeights(Index num_correspondences);

  /// @param weight  weight(i, scale), in [0, 1], that does not fall as the scale grows; the one at
  ///   the end of a group bounds the others. Memory at most 32 N values of 4 bytes.
  BinGroupWeights(Index num_correspondences, const ScaleBins& bins,
                  const std::function<double(Index i, double scale)>& weight);

  bool all_one() const { return shift_ == kOneGroup; }
  Index group_of(Index bin) const { return bin >> shift_; }
  Index first_of_group(Index group) const { return group << shift_; }

  /// Weights of all correspondences in a group.
  const std::uint32_t* group(Index group) const {
    return weights_.data() + group * num_correspondences_;
  }

 private:
  static constexpr int kOneGroup = 16;  // no bin has a number as large as 2^16

  Index num_correspondences_ = 0;
  int shift_ = kOneGroup;
  std::vector<std::uint32_t> weights_;
};

/// How much evidence votes for each bin, and what that leaves possible.
struct ScaleVotes {
  std::vector<Index> pairs;      ///< number of pairs whose interval (L1) meets the bin
  std::vector<double> evidence;  ///< sum over those pairs of w_i w_j
  /// Bounds on the consensus sets at scales of the bin, from what each correspondence agrees with:
  /// each of m inliers agrees with m - 1 others, so m correspondences must agree with as many, and
  /// likewise for sums of weights.
  std::vector<double> max_members, max_evidence;
  /// Pairs i < j of each chunk of kRowsPerChunk correspondences i: chunk-major, one value a bin.
  std::vector<std::uint32_t> pairs_of_chunks;

  static constexpr Index kRowsPerChunk = 64;
};

/// Votes of all pairs, streamed: no record of a pair is kept (L5).
/// @param max_bytes  for the tables of all threads; fewer threads are used where they do not fit,
///   but one.
/// @return the same for any number of threads. Where the deadline passes first, `evidence` is that
///   of a part of the pairs, every pair votes for every bin in `pairs` and the bounds, which bounds
///   too, and `pairs_of_chunks` is empty.
/// Cost O(N^2 + N bins), memory O(bins log N) a thread and O(bins N / 64).
ScaleVotes count_scale_votes(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
                             const BinGroupWeights& weights, std::size_t max_bytes, int num_threads,
                             const parallel::Deadline& deadline = parallel::Deadline::never());

}  // namespace gmcr::search
