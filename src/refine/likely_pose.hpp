#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace gmcr::refine {

/// The likeliest pose near one that holds many correspondences, and so the most accurate: residuals
/// of right matches follow a distribution whose width, share and tails come from the residuals
/// themselves (`estimation::NoiseMixture`), whatever the noise bound. Cost O(N), and a few dozen
/// passes over the correspondences within 3 bounds.
/// @return `start` where the fits leave its consensus set, and where no admitted pose is found.
problem::CentredPose most_likely_pose(const problem::Problem& problem,
                                      const problem::CentredPose& start);

/// The same of each.
std::vector<problem::CentredPose> most_likely_poses(const problem::Problem& problem,
                                                    std::vector<problem::CentredPose> poses);

}  // namespace gmcr::refine
