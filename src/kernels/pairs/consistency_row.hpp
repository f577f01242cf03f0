#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Whether correspondences i and j agree at some scale of [scale_min, scale_max] (L1):
///   |b_j - b_i| - e <= scale_max |a_j - a_i|  and  |b_j - b_i| + e >= scale_min |a_j - a_i|,
/// with e = bounds_i + bounds_j. Symmetric in i and j, bit for bit.
bool is_consistent(const geometry::CorrespondenceArrays& arrays, Index i, Index j, double scale_min,
                   double scale_max);

/// Which correspondences agree with number `i`, by the instruction set of this machine; only the
/// words from `first_word` on are written.
/// @param row  (N + 63) / 64 words; bit j is set iff j agrees with i and j != i.
/// The same bits as the reference on every instruction set. Cost O(N).
void consistency_row(const geometry::CorrespondenceArrays& arrays, Index i, double scale_min,
                     double scale_max, std::span<std::uint64_t> row, Index first_word = 0);

/// One word of that row; the bit of `i` itself, if it is there, is left undefined.
std::uint64_t consistency_word(const geometry::CorrespondenceArrays& arrays, Index i,
                               double scale_min, double scale_max, Index word);

/// The row, one pair after the other: the specification of `consistency_row`.
void consistency_row_reference(const geometry::CorrespondenceArrays& arrays, Index i,
                               double scale_min, double scale_max, std::span<std::uint64_t> row);

}  // namespace gmcr::kernels
