#pragma once

#include "frontend/surface_judge.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// Moves the pose of `result` to that of the candidate, and judges it anew.
CloudResult take(CloudResult result, const Candidate& candidate, const Options& options);

/// Moves the pose of `result` to where finer voxels of its clouds meet best, from where it is
/// nearly there, and judges it anew; adds to the stage "refinement". A result without a pose stays
/// as it is.
/// @param matched  the pose that the matches gave, of which the note speaks.
CloudResult settle(CloudResult result, const PointsRef& source, const PointsRef& target,
                   const Similarity& matched, const Options& options,
                   const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
