#pragma once

#include <Eigen/Core>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Angle of the rotation between two rotations, degrees in [0, 180] (geodesic distance on SO(3)).
/// Exact to about 1e-13 degrees for small angles too, where the arccos of the trace is not.
double rotation_error_deg(const Eigen::Matrix3d& estimate, const Eigen::Matrix3d& truth);

/// Distance between two translations, metres.
double translation_error(const Eigen::Vector3d& estimate, const Eigen::Vector3d& truth);

/// |estimate / truth - 1|, no unit.
double scale_error(double estimate, double truth);

/// Mean distance between the images of `points` (3 x N, source frame, N >= 1) under the two
/// transforms, metres, target frame: the ADD error (Hodan et al. 2016), without symmetries.
/// @throws std::invalid_argument where `points` is empty.
double mean_point_error(const Similarity& estimate, const Similarity& truth,
                        const PointsRef& points);

}  // namespace gmcr
