#pragma once

#include "gmcr/result.hpp"
#include "problem/objective.hpp"
#include "problem/run.hpp"
#include "search/best_poses.hpp"

namespace gmcr::registration {

/// Fills transforms, inliers, certificate, status and uncertainty, all judged on the caller's
/// correspondences and poses between the caller's frames: these residuals are what the caller can
/// check.
/// @param found      poses between the caller's frames, and bounds for all of `input`.
/// @param input      all of the caller's correspondences, in the caller's frames.
/// @param objective  of the correspondences that were used, for their weights where these are all.
void conclude(Result& result, problem::SolveContext& context, const search::MethodResult& found,
              const problem::Correspondences& input, const problem::Objective& objective);

}  // namespace gmcr::registration
