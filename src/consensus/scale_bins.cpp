#include "consensus/scale_bins.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gmcr {
namespace {

using kernels::ScaleCells;

std::uint64_t cell_of(double scale) {
  return std::bit_cast<std::uint64_t>(scale) >> ScaleCells::kShift;
}

}  // namespace

ScaleBins::ScaleBins(const ScaleRange& range, double ratio) : first_cell_(cell_of(range.min)) {
  const double log_min = std::log(range.min), log_span = std::log(range.max) - log_min;
  const double log_ratio = std::max(std::log(ratio), log_span / static_cast<double>(kMaxBins));
  const double count = std::ceil(log_span / log_ratio - 1e-9);
  edges_.push_back(range.min);
  for (double b = 1; b < count; ++b) {
    const double next = std::exp(log_min + b * log_ratio);
    // no two edges between bins in one cell
    const bool is_alone = edges_.size() == 1 || cell_of(next) != cell_of(edges_.back());
    if (is_alone && next > edges_.back() && next < range.max) edges_.push_back(next);
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

}  // namespace gmcr
