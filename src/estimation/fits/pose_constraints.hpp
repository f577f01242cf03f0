#pragma once

#include <Eigen/Core>

#include "gmcr/options.hpp"
#include "gmcr/priors.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// What a pose between two centred frames must satisfy.
struct PoseConstraints {
  ScaleRange scales;   ///< where the scale must lie; min == max: it is known
  Priors priors = {};  ///< of the transform between the caller's frames
  Eigen::Vector3d source_origin = Eigen::Vector3d::Zero();  ///< of the centred frame, in the
  Eigen::Vector3d target_origin = Eigen::Vector3d::Zero();  ///< caller's, metres
};

/// How much of the rotation the priors fix, but for a turn that hardly moves a scene.
enum class KnownRotation {
  None,
  ButAboutAxis,  ///< gravity, with hardly any tilt: the rotation about it is free
  All,           ///< an initial pose that the rotation hardly differs from
};
KnownRotation known_rotation(const Priors& priors);

/// How many correspondences determine a pose, with what is known: each fixes three of the up to
/// seven unknowns, and two of them never the turn about the line through both.
Index min_correspondences(const Priors& priors, bool scale_is_known);

inline Index min_correspondences(const PoseConstraints& constraints) {
  return min_correspondences(constraints.priors, constraints.scales.min == constraints.scales.max);
}

/// The same at one scale.
inline PoseConstraints at_scale(PoseConstraints constraints, double scale) {
  constraints.scales = {scale, scale};
  return constraints;
}

}  // namespace gmcr::estimation
