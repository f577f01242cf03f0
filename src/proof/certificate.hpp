#pragma once

#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr::proof {

/// Largest m with m (m - 1) / 2 <= num_pairs: m inliers need that many agreeing pairs (L5).
Index max_members(Index num_pairs);

/// Certificate of an achieved number of inliers and their evidence, and proven upper bounds on
/// both; evidence is at most the number of inliers.
Certificate certify(Index lower, Index upper, double evidence, double evidence_upper);

}  // namespace gmcr::proof
