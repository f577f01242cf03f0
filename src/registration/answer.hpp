#pragma once

#include <vector>

#include "gmcr/result.hpp"
#include "problem/problem.hpp"

namespace gmcr::registration {

/// Transforms, inliers, certificate, status and uncertainty, all judged on the caller's
/// correspondences and poses between the caller's frames: these residuals are what the caller can
/// check.
/// @param fitted  a pose near each of `found.poses`, which is returned in its place. The
///   certificate speaks of the pose that was found.
Result answer(const problem::Problem& problem, const problem::Found& found,
              const std::vector<problem::CentredPose>& fitted, problem::Run& run);

}  // namespace gmcr::registration
