#pragma once

#include "gmcr/frontend.hpp"
#include "gmcr/report.hpp"

namespace gmcr::cli {

/// Refines the pose of `result` by point-to-plane ICP on its voxel clouds (Open3D), at its scale.
///
/// Where the refined pose keeps the fitness and most of the inliers it replaces the pose and all
/// that was said of it (`with_pose`); otherwise `result` keeps what it has. A stage "refinement" is
/// added to its times.
/// @param options  that the registration used.
Refinement refine_with_icp(CloudResult& result, const Options& options);

}  // namespace gmcr::cli
