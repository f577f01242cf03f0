#pragma once

#include <Eigen/Core>
#include <functional>

#include "gmcr/types.hpp"

namespace gmcr::problem {

/// Calls visit(i, j, reach) once for each pair of points that are within
/// reach = reaches_i + reaches_j of each other, until it returns false.
///
/// The points lie in grids of cells as wide as what they reach, one grid for all of about the same
/// reach, so that one point that reaches far does not make the cells of all others wide. The order
/// of the visits depends on the input only.
/// @param points   3 x N, metres, finite.  @param reaches  N lengths, metres, > 0.
/// @return whether all pairs were visited. Cost O(N log N + pairs in neighbouring cells).
bool for_each_near_pair(const PointsRef& points, const Eigen::ArrayXd& reaches,
                        const std::function<bool(Index i, Index j, double reach)>& visit);

}  // namespace gmcr::problem
