#pragma once

#include <Eigen/Core>
#include <optional>

#include "gmcr/priors.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr::estimation {

/// Rotation that the priors admit and that fits a cross-covariance H = sum_k w_k b_k a_k^T well.
///
/// The argmax over SO(3) of tr(R^T H) where the priors admit it. Otherwise the direction of gravity
/// is moved to the nearest place that they leave it, by the least rotation, and the rotation about
/// it maximises tr(R^T H): in closed form, and for a tilt of 0 the best one there is. Without
/// gravity the turn away from the initial rotation is cut off.
/// @return nullopt where no rotation is found that all priors admit.
std::optional<Eigen::Matrix3d> admitted_rotation(const Eigen::Matrix3d& covariance,
                                                 const Priors& priors);

/// Translation nearest to `translation` that the priors admit; nullopt where they contradict each
/// other.
std::optional<Eigen::Vector3d> admitted_translation(const Eigen::Vector3d& translation,
                                                    const Priors& priors);

/// The pose with the nearest translation that the priors admit, between the caller's frames;
/// nullopt where they do not admit its rotation. Without priors, the pose as it is.
std::optional<Similarity> admitted_pose(const Similarity& pose, const Priors& priors);

}  // namespace gmcr::estimation
