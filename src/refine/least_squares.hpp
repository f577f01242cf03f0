#pragma once

#include "estimation/pose_constraints.hpp"
#include "problem/objective.hpp"

namespace gmcr::refine {

/// Least-squares fit to the consensus set of a pose, and to that of the fit, until it stays the
/// same or 20 fits were made. Cost O(N) a fit.
/// @param start  between the centred frames, as the result.
/// @return the last fit that the constraints admit and that holds at least 3; `start` where there
///   is none.
Similarity fit_to_consensus(const problem::Objective& objective,
                            const estimation::PoseConstraints& constraints,
                            const Similarity& start);

}  // namespace gmcr::refine
