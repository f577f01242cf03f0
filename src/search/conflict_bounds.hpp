#pragma once

#include "problem/objective/measure.hpp"
#include "problem/problem.hpp"

namespace gmcr::search {

/// Upper bounds on what any pose holds, from how many inliers of one pose each of the others
/// conflicts with (L8): no graph is built.
///
/// Close to what the pose holds where most are right; the sums over all where the scale is unknown,
/// as pairs of a range hardly conflict, and where the others are too many for some 0.5 ms.
/// Cost O(M^2) for M others, at most 2^20 pairs.
problem::PerMeasure bounds_by_conflicts(const problem::Problem& problem,
                                        const problem::Hypothesis& best);

}  // namespace gmcr::search
