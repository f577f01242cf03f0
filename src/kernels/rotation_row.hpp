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
///   |angle(a_k, a_l) - angle(b_k, b_l)| <= gamma_k + gamma_l.
/// @param row  (K + 63) / 64 words; bit l is set iff l shares a rotation with k and l != k.
/// Symmetric in k and l, bit for bit. Cost O(K), no inverse trigonometry.
void rotation_row(const DirectionArrays& arrays, Index k, std::span<std::uint64_t> row);

}  // namespace gmcr::kernels
