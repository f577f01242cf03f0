#pragma once

#include "gmcr/result.hpp"
#include "registration/gmcr_method.hpp"
#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// Fills transforms, inliers, certificate, status and uncertainty, all judged on the caller's
/// correspondences and poses between the caller's frames: these residuals are what the caller can
/// check.
/// @param found      poses between the caller's frames, and bounds for all of `input`.
/// @param input      all of the caller's correspondences, in the caller's frames.
/// @param objective  of the correspondences that were used, for their weights where these are all.
void conclude(Result& result, SolveContext& context, const MethodResult& found,
              const Correspondences& input, const Objective& objective);

}  // namespace gmcr
