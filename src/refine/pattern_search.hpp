#pragma once

#include "estimation/pose_constraints.hpp"
#include "problem/objective.hpp"

namespace gmcr::refine {

/// Small motions of a pose that the objective takes for better ones (pattern search, Hooke and
/// Jeeves 1961).
///
/// Least-squares fits settle where their consensus set explains itself, whereas the objective is a
/// step function: turns and shifts by parts of a bound, each tried on the correspondences near the
/// pose alone, climb on where it is ragged. Deterministic.
/// @param constraints  what the pose must satisfy.
/// @return never worse than `best` by the objective. Cost O(N), and a few hundred passes over the
///   correspondences near the pose where these are some hundreds; fewer where they are more.
problem::Hypothesis climb_by_motions(const problem::Objective& objective,
                                     const estimation::PoseConstraints& constraints,
                                     problem::Hypothesis best);

}  // namespace gmcr::refine
