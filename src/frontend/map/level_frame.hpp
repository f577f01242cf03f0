#pragma once

#include <Eigen/Core>

namespace gmcr::frontend {

/// Heights and places of a frame whose vertical is known: rotated so that z is up.
/// @param up  any length > 0.
/// @return the rotation; the shortest one.
Eigen::Matrix3d level_rotation(const Eigen::Vector3d& up);

/// A ground that rises evenly: height = a x + b y + c in a level frame.
struct GroundPlane {
  double a = 0, b = 0, c = 0;

  double height(double x, double y) const { return a * x + b * y + c; }
  Eigen::Vector3d up() const { return Eigen::Vector3d(-a, -b, 1).normalized(); }
};

}  // namespace gmcr::frontend
