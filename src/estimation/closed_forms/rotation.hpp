#pragma once

#include <Eigen/Core>
#include <optional>

#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// Rotation of a 3 x 3 cross-covariance sum_k w_k b_k a_k^T: argmax over SO(3) of tr(R^T H).
/// @return R with det R = +1, or nullopt where the second singular value is below 1e-12 of the
///   first, so that R is not unique.
std::optional<Eigen::Matrix3d> rotation_from_covariance(const Eigen::Matrix3d& covariance);

/// The least rotation that turns the axis of a cross-covariance of rank 1 onto its image.
Eigen::Matrix3d least_rotation(const Eigen::Matrix3d& covariance);

/// Rotation that maps the vectors of `a` onto those of `b` best in the least-squares sense.
///
/// Solves  min_R  sum_k |b_k - R a_k|^2  over SO(3)  (Arun et al. 1987; reflection as in Umeyama
/// 1991).
/// @param a, b  3 x K, the same K, metres, finite.
/// @return R with det R = +1, or nullopt where the vectors span less than a plane and R is not
///   unique.
/// @throws std::invalid_argument on a shape mismatch. Cost O(K).
std::optional<Eigen::Matrix3d> estimate_rotation(const PointsRef& a, const PointsRef& b);

}  // namespace gmcr::estimation
