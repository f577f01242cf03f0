#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
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

  Index size() const { return static_cast<Index>(edges_.size()) - 1; }
  ScaleRange operator[](Index bin) const { return {edge(bin), edge(bin + 1)}; }

  /// Runs of neighbouring bins over which what changes slowly with the scale is taken as constant.
  Index num_runs() const { return run_of(size() - 1) + 1; }
  Index run_of(Index bin) const { return bin / kBinsPerRun; }
  Index last_of_run(Index run) const { return std::min(size(), (run + 1) * kBinsPerRun) - 1; }

  /// Bins that [lower, upper] can meet, as [first, last]; first > last: none. Never misses one for
  /// the rounding of its ends; may name a neighbour that it only touches. Cost O(1), no logarithm.
  std::pair<Index, Index> covering(double lower, double upper) const {
    constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
    lower -= kRounding * std::abs(lower);
    upper += kRounding * std::abs(upper);
    if (!(lower <= edges_.back() && upper >= edges_.front())) return {0, -1};
    Index first = 0, last = size() - 1;
    if (lower > edges_.front()) {
      for (first = near(lower); edge(first + 1) < lower;) ++first;
    }
    if (upper < edges_.back()) {
      for (last = near(upper); edge(last + 1) <= upper;) ++last;
    }
    return {first, last};
  }

 private:
  static constexpr Index kBinsPerRun = 16;
  static constexpr int kCellShift = 44;  // leaves 8 bits of the fraction: cells of up to 0.4 %

  /// Number of the cell of a positive scale: as the bits of a double ascend with its value, those
  /// of exponent and first digits number cells of a like ratio.
  static std::uint64_t cell(double scale) {
    return std::bit_cast<std::uint64_t>(scale) >> kCellShift;
  }

  double edge(Index bin) const { return edges_[static_cast<std::size_t>(bin)]; }

  /// The bin of the lower end of the cell of a scale within the range.
  Index near(double scale) const { return bin_of_cell_[cell(scale) - first_cell_]; }

  std::vector<double> edges_;  ///< of the bins, ascending; one more than these
  std::uint64_t first_cell_ = 0;
  std::vector<std::int32_t> bin_of_cell_;
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
