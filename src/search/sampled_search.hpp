#pragma once

#include "problem/problem.hpp"

namespace gmcr::search {

/// The coarser route where the graph of all correspondences exceeds the memory or the time: the
/// search for the best pose among an even selection of them, whose poses are fitted to and judged
/// on all. The selection grows until the pose is beyond chance in it, or the memory or the time is
/// spent; the first one is searched in any case.
///
/// A pose that a share p of N correspondences suits has about p M of a selection of M: it is found
/// where that towers over chance. Poses of fewer may exist: no more is proven than that
/// no pose has more inliers than there are correspondences.
/// @param problem  one for which it is meant, `Problem::is_sampled`.
problem::Found sampled_search(const problem::Problem& problem, problem::Run& run);

}  // namespace gmcr::search
