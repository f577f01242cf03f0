#pragma once

#include <Eigen/Core>

namespace gmcr::geometry {

/// Unit normal of the plane that points of a covariance lie nearest to: its axis of least spread,
/// of either sign. 0 where they lie on a line, or all in one place.
Eigen::Vector3d plane_normal(const Eigen::Matrix3d& covariance);

}  // namespace gmcr::geometry
