#pragma once

#include <Eigen/Geometry>

#include "gmcr/priors.hpp"

namespace gmcr::geometry {

/// Rounding that an angle of a prior is granted, radians.
inline constexpr double kAngleSlack = 1e-9;

/// Angle between two vectors of any length > 0, radians in [0, pi]; exact for small ones too.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Angle of a rotation, radians in [0, pi].
double rotation_angle(const Eigen::Matrix3d& rotation);

/// The exact rotation next to one that is orthonormal to rounding.
Eigen::Matrix3d exact_rotation(const Eigen::Matrix3d& rotation);

/// The turn by an angle about a unit axis.
Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle);

/// The axis, of length 1, and the angle, radians in [0, pi], of a rotation.
struct AxisAngle {
  Eigen::Vector3d axis;
  double angle;
};
AxisAngle axis_angle(const Eigen::Matrix3d& rotation);

/// The least turn that takes a direction to another, of any length > 0.
Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angle by which a rotation tilts the direction of gravity, radians.
double tilt(const GravityPrior& gravity, const Eigen::Matrix3d& rotation);

/// Angle between a rotation and that of an initial pose, radians.
double turn_from(const InitialPose& initial, const Eigen::Matrix3d& rotation);

}  // namespace gmcr::geometry
