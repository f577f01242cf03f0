#pragma once

#include <optional>
#include <vector>

#include "estimation/pose_constraints.hpp"
#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// Best pose that a clique of the consistency graph leads to, judged on all correspondences (L7).
///
/// First the closed form on the whole clique. Where the pose does not hold all of the clique, which
/// pairwise distances allow (mirrored and loosely fitting sets), also fits that try to, and then
/// the rotation and translation stages on its longest TIMs, which look for a part of it.
/// @param must_exceed  evidence of a rival: a clique that gives no more has no part worth the
/// stages.
/// @param constraints  what the pose must satisfy.
/// @return nullopt where the clique has fewer than 3 vertices or leads to no admitted pose.
std::optional<Hypothesis> pose_from_clique(SolveContext& context, const Objective& objective,
                                           const PoseConstraints& constraints,
                                           const std::vector<Index>& clique, double must_exceed);

}  // namespace gmcr
