#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"
#include "problem/run.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::search {

/// Best pose that a clique of the consistency graph leads to, judged on all correspondences (L7).
///
/// First the closed form on the whole clique. Where the pose does not hold all of the clique, which
/// pairwise distances allow (mirrored and loosely fitting sets), also fits that try to, and then
/// the rotation and translation stages on its longest TIMs, which look for a part of it.
/// @param incumbent  a clique that gives no more evidence, or whose pose is near, has no part worth
/// the
///   stages.
/// @return nullopt where the clique has fewer than 3 vertices, leads to no admitted pose, or leads
///   to an exhausted incumbent.
std::optional<problem::Hypothesis> pose_from_clique(const problem::Problem& problem,
                                                    problem::Run& run,
                                                    const std::vector<Index>& clique,
                                                    const refine::Incumbent& incumbent);

}  // namespace gmcr::search
