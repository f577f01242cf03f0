#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "gmcr/options.hpp"
#include "kernels/consistency_row.hpp"
#include "parallel/deadline.hpp"

namespace gmcr {

/// A range of scales cut into bins of equal ratio.
class ScaleBins {
 public:
  /// @param ratio  upper over lower edge of a bin, > 1; the last bin may be narrower.
  ScaleBins(const ScaleRange& range, double ratio);

  Index size() const { return count_; }
  ScaleRange operator[](Index bin) const;

  /// Runs of neighbouring bins over which what changes slowly with the scale is taken as constant.
  Index num_runs() const { return run_of(count_ - 1) + 1; }
  Index run_of(Index bin) const { return bin / kBinsPerRun; }
  Index last_of_run(Index run) const { return std::min(count_, (run + 1) * kBinsPerRun) - 1; }

  /// Bins that [lower, upper] can meet, as [first, last]; first > last: none. Never misses one; may
  /// name a neighbour that it only touches.
  std::pair<Index, Index> covering(double lower, double upper) const;

 private:
  static constexpr Index kBinsPerRun = 16;

  ScaleRange range_;
  double log_min_, log_ratio_;
  Index count_;
};

/// Calls visit(i, j, first_bin, last_bin) for each pair i < j with i in [begin, end) whose interval
/// of scales (L1) meets a bin, in order.
template <typename Visit>
void for_each_voting_pair(const kernels::CorrespondenceArrays& arrays, const ScaleBins& bins,
                          Index begin, Index end, const Visit& visit) {
  std::vector<double> source(static_cast<std::size_t>(arrays.size())), target(source);
  for (Index i = begin; i < end; ++i) {
    kernels::pair_lengths(arrays, i, source, target);
    for (Index j = i + 1; j < arrays.size(); ++j) {
      const double a = source[static_cast<std::size_t>(j - i - 1)];
      const double b = target[static_cast<std::size_t>(j - i - 1)];
      const double bound = arrays.bounds[i] + arrays.bounds[j];
      // coincident source points agree at every scale or at none
      const auto [first, last] =
          a > 0 ? bins.covering((b - bound) / a, (b + bound) / a)
                : std::pair<Index, Index>{0, b <= bound ? bins.size() - 1 : -1};
      if (first <= last) visit(i, j, first, last);
    }
  }
}

/// How much evidence votes for each bin.
struct ScaleVotes {
  std::vector<Index> pairs;      ///< number of pairs whose interval (L1) meets the bin
  std::vector<double> evidence;  ///< sum over those pairs of w_i w_j
};

/// Votes of all pairs, streamed: no record of a pair is kept (L5).
/// @param weight  w_i in a run of bins: weight(i, run); must be safe to call from several threads.
/// @return where the deadline passes first: every pair votes for every bin, which is a bound too.
/// Cost O(N^2 + bins), memory O(bins) a chunk of rows.
ScaleVotes count_scale_votes(const kernels::CorrespondenceArrays& arrays, const ScaleBins& bins,
                             const std::function<double(Index i, Index run)>& weight,
                             int num_threads, const Deadline& deadline = Deadline::never());

}  // namespace gmcr
