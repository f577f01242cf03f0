#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// TIMs as unit directions and the half-angle gamma of the cone of rotations that each admits.
struct DirectionArrays {
  Eigen::MatrixX3d source, target;      ///< K x 3, unit vectors
  Eigen::ArrayXd cos_gamma, sin_gamma;  ///< K values, gamma in [0, pi]

  Index size() const { return source.rows(); }
};

/// Which TIMs share a rotation with number `k` (L3):
///   |angle(a_k, a_l) - angle(b_k, b_l)| <= gamma_k + gamma_l,
/// by the instruction set of this machine; only the words from `first_word` on are written.
/// @param row  (K + 63) / 64 words; bit l is set iff l shares a rotation with k and l != k.
/// Symmetric in k and l, bit for bit, and the same bits as the reference on every instruction set.
/// Cost O(K), no inverse trigonometry.
void rotation_row(const DirectionArrays& arrays, Index k, std::span<std::uint64_t> row,
                  Index first_word = 0);

/// The row, one pair after the other: the specification.
void rotation_row_reference(const DirectionArrays& arrays, Index k, std::span<std::uint64_t> row);

/// Whether TIMs k and l share a rotation.
bool shares_rotation(const DirectionArrays& arrays, Index k, Index l);

constexpr double kCosineSlack = 1e-14;  ///< rounding of the cosines; an edge in doubt is kept

}  // namespace gmcr::kernels
