#pragma once

#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// Moves the pose of `result` to where its voxel clouds meet best, and judges it anew; adds to the
/// stage "refinement". A result without a pose of its own stays as it is.
CloudResult approach(CloudResult result, const Options& options,
                     const parallel::Deadline& deadline);

/// The same on finer voxels of the clouds, from a pose that is nearly there.
/// @param matched  the pose that the matches gave, of which the note speaks.
CloudResult settle(CloudResult result, const PointsRef& source, const PointsRef& target,
                   const Similarity& matched, const Options& options,
                   const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
