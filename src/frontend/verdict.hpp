#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr {

/// Judges the pose of `result` by its inliers, matches and fitness; writes verdict and reason.
void judge(CloudResult& result);

}  // namespace gmcr
