#pragma once

#include "problem/problem.hpp"

namespace gmcr::refine {

/// Least-squares fit to the consensus set of a pose, and to that of the fit, until it stays the
/// same or 20 fits were made. Cost O(N) a fit.
/// @return the last fit that the constraints admit and that holds at least 3; `start` where there
///   is none.
problem::CentredPose fit_to_consensus(const problem::Problem& problem,
                                      const problem::CentredPose& start);

/// The same of every pose that was found.
problem::Found fit_to_consensus(const problem::Problem& problem, problem::Found found);

}  // namespace gmcr::refine
