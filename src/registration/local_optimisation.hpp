#pragma once

#include "gmcr/options.hpp"
#include "registration/objective.hpp"

namespace gmcr {

/// Best pose met while fitting to the consensus set of the pose, again and again: within 2 eps, 1.5
/// eps, then eps until the set no longer changes.
/// @param scales  where the scale must lie.
/// @return never worse than `start` by the objective.
Hypothesis optimise_locally(const Objective& objective, const ScaleRange& scales,
                            const Similarity& start);

}  // namespace gmcr
