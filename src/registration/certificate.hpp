#pragma once

#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr {

/// Largest m with m (m - 1) / 2 <= num_pairs: m inliers need that many agreeing pairs (L5).
Index max_members(Index num_pairs);

/// Certificate of an achieved number of inliers and a proven upper bound on it.
Certificate certify(Index lower, Index upper);

}  // namespace gmcr
