#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Correspondences as one array a coordinate, the layout that the row kernels read.
struct CorrespondenceArrays {
  Eigen::MatrixX3d source, target;  ///< N x 3, metres
  Eigen::ArrayXd bounds;            ///< N inlier bounds, metres

  Index size() const { return source.rows(); }
};

/// Whether correspondences i and j agree at some scale of [scale_min, scale_max] (L1):
///   |b_j - b_i| - e <= scale_max |a_j - a_i|  and  |b_j - b_i| + e >= scale_min |a_j - a_i|,
/// with e = bounds_i + bounds_j. Symmetric in i and j, bit for bit.
bool is_consistent(const CorrespondenceArrays& arrays, Index i, Index j, double scale_min,
                   double scale_max);

/// Which correspondences agree with number `i`, by the instruction set of this machine; only the
/// words from `first_word` on are written.
/// @param row  (N + 63) / 64 words; bit j is set iff j agrees with i and j != i.
/// The same bits as the reference on every instruction set. Cost O(N).
void consistency_row(const CorrespondenceArrays& arrays, Index i, double scale_min,
                     double scale_max, std::span<std::uint64_t> row, Index first_word = 0);

/// One word of that row; the bit of `i` itself, if it is there, is left undefined.
std::uint64_t consistency_word(const CorrespondenceArrays& arrays, Index i, double scale_min,
                               double scale_max, Index word);

/// The row, one pair after the other: the specification of `consistency_row`.
void consistency_row_reference(const CorrespondenceArrays& arrays, Index i, double scale_min,
                               double scale_max, std::span<std::uint64_t> row);

/// Lengths |a_j - a_i| and |b_j - b_i| for each j in [i + 1, N), in order, by the instruction set
/// of this machine.
/// @param source_lengths, target_lengths  N - i - 1 values, metres.
void pair_lengths(const CorrespondenceArrays& arrays, Index i, std::span<double> source_lengths,
                  std::span<double> target_lengths);

/// The same, one pair after the other, for each j in [max(first, i + 1), N): the specification.
void pair_lengths_reference(const CorrespondenceArrays& arrays, Index i,
                            std::span<double> source_lengths, std::span<double> target_lengths,
                            Index first = 0);

}  // namespace gmcr::kernels
