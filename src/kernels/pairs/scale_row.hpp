#pragma once

#include <cstdint>
#include <span>

#include "gmcr/types.hpp"
#include "kernels/pairs/consistency_row.hpp"

namespace gmcr::kernels {

/// Bins [begin, end) of scales; begin == end: none.
struct BinSpan {
  std::uint32_t packed = 0;  ///< the end above bit 16

  static BinSpan of(std::uint64_t begin, std::uint64_t end) {
    return {static_cast<std::uint32_t>(begin | end << 16)};
  }
  Index begin() const { return packed & 0xffff; }
  Index end() const { return packed >> 16; }
  bool operator==(const BinSpan&) const = default;
};

/// Which bin a scale of [min, max] falls into, as a table.
///
/// The bits of a positive double ascend with its value, so that those of the exponent and the first
/// digits number cells of a like ratio. No cell holds more than one edge between two bins. The
/// entry of a cell has the bin at its lower end above bit kShift and, where an edge is in the cell,
/// what makes the further digits of a scale beyond the edge carry into that.
struct ScaleCells {
  static constexpr int kShift = 44;  ///< leaves 8 digits: cells of up to 0.4 %
  static constexpr std::uint64_t kRest = (std::uint64_t{1} << kShift) - 1;

  double min = 0, max = 0;
  std::uint64_t first = 0;                 ///< number of the cell of min
  const std::uint64_t* entries = nullptr;  ///< of the cells from that of min to that of max
};

/// Bins that [lower, upper] can meet, widened by `slack` for the rounding of its ends. Never misses
/// one; may name a neighbour that it only touches. NaN meets none.
BinSpan covered_bins(const ScaleCells& cells, double lower, double upper, double slack);

/// Bins at whose scales i and j agree (L1):
///   (|b_j - b_i| - e) / |a_j - a_i| <= scale <= (|b_j - b_i| + e) / |a_j - a_i|.
/// Names more bins than those only where the interval ends within rounding of an edge, or the
/// source points coincide to less than 1e-100 m.
BinSpan agreeing_bins(const geometry::CorrespondenceArrays& arrays, const ScaleCells& cells,
                      Index i, Index j);

/// The same for i and each j in [begin, N), by the instruction set of this machine: the same bins
/// on every one.
/// @param spans  N entries; those before `begin` may be written too. Entry i means nothing.
/// Cost O(N), a table lookup for each end of an interval.
void scale_row(const geometry::CorrespondenceArrays& arrays, const ScaleCells& cells, Index i,
               Index begin, std::span<BinSpan> spans);

}  // namespace gmcr::kernels
