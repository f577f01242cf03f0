#pragma once

#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/types.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::registration {

/// How many correspondences a reflection holds: data of one right-handed and one left-handed frame
/// agree with a rotation on one flat set only, and with the reflection across it everywhere.
/// @param inliers  those of the pose, ascending.
/// @return 0 where most inliers are not flat within a few noise bounds, or span no plane.
/// Cost O(N) where they are flat, else O(number of inliers).
Index reflected_inliers(const problem::CallerCorrespondences& all, const problem::CallerPose& pose,
                        const std::vector<Index>& inliers, const ScaleRange& scales);

}  // namespace gmcr::registration
