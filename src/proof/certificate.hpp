#pragma once

#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr::proof {

/// Certificate of an achieved number of inliers and their evidence, and proven upper bounds on
/// both; evidence is at most the number of inliers. The transform is left for the caller to give.
Certificate certify(Index lower, Index upper, double evidence, double evidence_upper);

}  // namespace gmcr::proof
