#pragma once

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// Mean of the points in each occupied cell of a cubic grid.
///
/// The grid starts at the smallest coordinates of the cloud, so a translation of the cloud
/// translates the result. Columns are in the order of the cells: x slowest, z fastest.
/// @param points      3 x N, metres, finite.
/// @param voxel_size  edge of a cell, metres, > 0, finite.
/// @return 3 x M, M <= N.
/// @throws std::invalid_argument naming `voxel_size` where an axis has more cells than 63 bits can
///   number.
/// Cost O(N log N). Deterministic.
Points voxel_grid(const PointsRef& points, double voxel_size);

}  // namespace gmcr::frontend
