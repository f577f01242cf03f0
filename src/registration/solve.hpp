#pragma once

#include "gmcr/result.hpp"
#include "problem/problem.hpp"

namespace gmcr::registration {

/// Search and proof: the poses that hold the most, and bounds that no pose exceeds.
problem::Found find(const problem::Problem& problem, problem::Run& run);

/// A whole solve with a given noise bound: `register_correspondences` without the checks of the
/// input.
Result solve(const PointsRef& source, const PointsRef& target, const Options& options);

}  // namespace gmcr::registration
