#pragma once

#include "gmcr/result.hpp"
#include "problem/problem.hpp"

namespace gmcr::registration {

/// Transforms, inliers, certificate, status and uncertainty, all judged on the caller's
/// correspondences and poses between the caller's frames: these residuals are what the caller can
/// check.
Result answer(const problem::Problem& problem, const problem::Found& found, problem::Run& run);

}  // namespace gmcr::registration
