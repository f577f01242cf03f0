#include "search/scales/scale_bins.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/elementary.hpp"

namespace gmcr::search {
namespace {

using kernels::ScaleCells;

std::uint64_t cell_of(double scale) {
  return std::bit_cast<std::uint64_t>(scale) >> ScaleCells::kShift;
}

}  // namespace

ScaleBins::ScaleBins(const ScaleRange& range, double ratio, const problem::ScaleBuckets& buckets)
    : first_cell_(cell_of(range.min)) {
  const double span = elementary::log2(range.max) - elementary::log2(range.min);
  // the widest range of all has 2,098 buckets
  const double num_that_fit = std::floor(static_cast<double>(kMaxBins - 1) / span);
  const int num_in_bucket =
      static_cast<int>(std::min(std::round(1 / elementary::log2(ratio)), num_that_fit));
  edges_.push_back(range.min);
  const double bucket =
      std::floor(elementary::log2(range.min) - elementary::log2(buckets.edge(0, 1)));
  for (int k = num_in_bucket * static_cast<int>(bucket);; ++k) {
    const double next = buckets.edge(k, num_in_bucket);
    if (!(next < range.max)) break;
    // no two edges between bins in one cell
    const bool is_alone = edges_.size() == 1 || cell_of(next) != cell_of(edges_.back());
    if (is_alone && next > edges_.back()) edges_.push_back(next);
  }
  edges_.push_back(range.max);

  std::uint64_t below = 0;  // edges between bins, so far
  for (std::uint64_t cell = first_cell_; cell <= cell_of(range.max); ++cell) {
    const double next = edges_[below + 1];
    const bool has_edge = static_cast<Index>(below) + 1 < size() && cell_of(next) == cell;
    const std::uint64_t digits = std::bit_cast<std::uint64_t>(next) & ScaleCells::kRest;
    entries_.push_back((below << ScaleCells::kShift) + (has_edge ? ScaleCells::kRest - digits : 0));
    below += has_edge;
  }
}

}  // namespace gmcr::search
