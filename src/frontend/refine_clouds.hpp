#pragma once

#include "frontend/judgement/surface_judge.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// Moves the pose of `result` to where finer voxels of its clouds meet best, from where it is
/// nearly there, and judges it anew; adds to the stage "refinement". A result without a pose stays
/// as it is.
/// @param result  with a pose.
/// @param voxels  the voxel clouds of `result.matches`.
/// @param matched  the pose that the matches gave, of which the note speaks.
CloudResult settle(CloudResult result, const PointsRef& source, const PointsRef& target,
                   CentredPair& voxels, const Similarity& matched, const Options& options,
                   const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
