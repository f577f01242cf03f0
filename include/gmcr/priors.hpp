#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "gmcr/similarity.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// The direction of gravity (or of any other known axis) in both frames: R turns one onto the
/// other, up to a tilt. With tilt 0 only the yaw about that direction is unknown.
struct GravityPrior {
  Eigen::Vector3d source = Eigen::Vector3d::Zero();  ///< source frame, any length > 0
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< target frame, any length > 0
  double max_tilt = 0;  ///< radians in [0, pi]: largest angle between R source and target
};

/// A pose that the transform is known to be near. Its scale is not used.
struct InitialPose {
  Similarity target_from_source;  ///< what it is near
  double max_rotation = 0;  ///< radians in [0, pi]: largest angle of the rotation between the two
  /// Metres, >= 0; infinity: any. Largest distance of the two translations, which are the images of
  /// the origin of the source frame.
  double max_translation = std::numeric_limits<double>::infinity();
};

/// What is known of the transform beforehand. Only transforms that it admits are looked for, and
/// the certificate speaks of these.
struct Priors {
  std::optional<GravityPrior> gravity;      ///< which way is up, in both frames
  std::optional<InitialPose> initial_pose;  ///< such as that of odometry
  double max_translation = std::numeric_limits<double>::infinity();  ///< metres, > 0, of |t|

  /// Whether nothing is known: every transform is admitted.
  bool admit_all() const {
    return !gravity && !initial_pose && max_translation == std::numeric_limits<double>::infinity();
  }

  /// Whether the transform satisfies all of them, to rounding.
  bool admit(const Similarity& target_from_source) const;

  /// @throws InvalidOption naming option and value.
  void validate() const;
};

}  // namespace gmcr
