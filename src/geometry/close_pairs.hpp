#pragma once

#include <Eigen/Core>
#include <functional>

#include "gmcr/types.hpp"

namespace gmcr::geometry {

/// Calls visit(i, j, radius) once for each pair of points that are within
/// radius = 2 min(radii_i, radii_j) of each other, until it returns false.
///
/// The points of about the same radius lie in a grid of cells twice as wide, and those of larger
/// radii are looked up in it: a few of large radius cost no more than others. The order
/// of the visits depends on the input only.
/// @param points   3 x N, metres, finite.  @param radii  N lengths, metres, > 0.
/// @return whether all pairs were visited. Cost O(N log N + pairs in neighbouring cells).
bool for_each_close_pair(const PointsRef& points, const Eigen::ArrayXd& radii,
                         const std::function<bool(Index i, Index j, double radius)>& visit);

}  // namespace gmcr::geometry
