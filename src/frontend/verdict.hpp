#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Judges the pose of `result` by its inliers, matches and fitness; writes verdict and reason. A
/// pose from matches that were not filtered is doubtful where the surfaces meet, and never trusted.
void judge(CloudResult& result);

}  // namespace gmcr::frontend
