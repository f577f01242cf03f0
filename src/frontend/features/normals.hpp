#pragma once

#include <Eigen/Core>

#include "frontend/points/neighbourhoods.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// Unit normal of the surface at each point: the direction in which its neighbours within `radius`
/// spread least.
///
/// @param points          3 x N.
/// @param neighbourhoods  of the points, with a radius of at least `radius`.
/// @return 3 x N, unit, of arbitrary sign; 0 where a point has fewer than 2 neighbours or they lie
///   on one line with it, so that there is no surface.
/// Cost O(number of neighbours). Deterministic for any thread count.
Points estimate_normals(const PointsRef& points, const Neighbourhoods& neighbourhoods,
                        double radius, int num_threads);

/// Turns each normal to the side on which `viewpoint` lies.
Points orient_toward(const PointsRef& points, const Points& normals,
                     const Eigen::Vector3d& viewpoint);

/// Turns each normal away from the mean of the points.
Points orient_outward(const PointsRef& points, const Points& normals);

}  // namespace gmcr::frontend
