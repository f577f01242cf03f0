#pragma once

#include <Eigen/Core>

#include "gmcr/options.hpp"
#include "gmcr/priors.hpp"

namespace gmcr::estimation {

/// What a pose between two centred frames must satisfy.
struct PoseConstraints {
  ScaleRange scales;   ///< where the scale must lie; min == max: it is known
  Priors priors = {};  ///< of the transform between the caller's frames
  Eigen::Vector3d source_origin = Eigen::Vector3d::Zero();  ///< of the centred frame, in the
  Eigen::Vector3d target_origin = Eigen::Vector3d::Zero();  ///< caller's, metres
};

/// The same at one scale.
inline PoseConstraints at_scale(PoseConstraints constraints, double scale) {
  constraints.scales = {scale, scale};
  return constraints;
}

}  // namespace gmcr::estimation
