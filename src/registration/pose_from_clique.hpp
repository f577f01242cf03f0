#pragma once

#include <optional>
#include <vector>

#include "gmcr/options.hpp"
#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// Best pose that a clique of the consistency graph leads to, judged on all correspondences (L7).
///
/// First the closed form on the whole clique. Where the pose does not hold all of the clique, which
/// pairwise distances allow (mirrored and loosely fitting sets), also the rotation and translation
/// stages on its longest TIMs.
/// @param scales  where the scale must lie.
/// @return nullopt where the clique has fewer than 3 vertices.
std::optional<Hypothesis> pose_from_clique(SolveContext& context, const Objective& objective,
                                           const ScaleRange& scales,
                                           const std::vector<Index>& clique);

}  // namespace gmcr
