#pragma once

#include <cstdint>
#include <vector>

#include "gmcr/options.hpp"
#include "kernels/pairs/scale_row.hpp"
#include "problem/scale_buckets.hpp"

namespace gmcr::search {

/// A range of scales cut into bins of equal ratio, so many to an bucket that each bucket ends with
/// a bin: within a bin the weights of evidence are the same.
class ScaleBins {
 public:
  static constexpr Index kMaxBins = 4096;

  /// @param ratio  upper over lower edge of a bin, about, in [1.01, 2]: buckets are divided evenly.
  ///   It is larger where the range would have more than kMaxBins of that. The first and the last
  ///   bin may be narrower.
  ScaleBins(const ScaleRange& range, double ratio,
            const problem::ScaleBuckets& buckets = problem::ScaleBuckets(1));

  Index size() const { return static_cast<Index>(edges_.size()) - 1; }
  ScaleRange operator[](Index bin) const { return {edge(bin), edge(bin + 1)}; }

  /// What the kernels read; points into these bins.
  kernels::ScaleCells cells() const {
    return {edges_.front(), edges_.back(), first_cell_, entries_.data()};
  }

 private:
  double edge(Index bin) const { return edges_[static_cast<std::size_t>(bin)]; }

  std::vector<double> edges_;  ///< of the bins, ascending; one more than these
  std::uint64_t first_cell_ = 0;
  std::vector<std::uint64_t> entries_;  ///< of the cells, see kernels::ScaleCells
};

}  // namespace gmcr::search
