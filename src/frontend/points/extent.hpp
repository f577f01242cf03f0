#pragma once

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// Size of a cloud that a few stray points or a long thin tail do not change: twice the 90th
/// percentile of the distance from the median point (median of each coordinate).
///
/// @param points  3 x N, finite, N >= 1.
/// @return metres, >= 0; 0 where almost all points coincide.
/// Cost O(N). Deterministic.
double robust_extent(const PointsRef& points);

}  // namespace gmcr::frontend
