#pragma once

#include "gmcr/result.hpp"
#include "problem/problem.hpp"

namespace gmcr::registration {

/// Fills the verdict of a result with a pose, and whether chance explains its consensus set
/// (`noise::log10_false_alarms`).
///
/// The number of inliers and of all correspondences is multiplied by the share of the others that
/// is distinct evidence: where wrong matches come as copies of each other, as those of raw clouds
/// do, chance gives many inliers as easily as few.
/// More than 20,000 correspondences are judged by a selection. Cost O(N) for the reflection,
/// where the inliers are flat, else that of the selection.
void judge(Result& result, const problem::Problem& problem, problem::Run& run);

/// Fills the verdict of a result without a pose.
void judge_without_pose(Result& result, const PointsRef& source, const PointsRef& target,
                        const Options& options);

}  // namespace gmcr::registration
