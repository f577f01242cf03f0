#pragma once

#include "frontend/alignment/centred_pair.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Points that lie no farther from a position than so many metres.
Points points_within(const PointsRef& points, const Eigen::Vector3d& position, double radius);

/// Pairs of voxels of the scan and of the map that meet under a pose: its matches, at most so many,
/// by a fixed stride.
/// @param matches  with the voxels of both and the noise bound.
/// @param voxels   the same voxels.
void match_by_pose(CloudMatches& matches, CentredPair& voxels, const Similarity& target_from_source,
                   int num_threads);

}  // namespace gmcr::frontend
