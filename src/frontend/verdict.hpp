#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr {

/// Judges the pose of `result` by its inliers, matches and fitness; writes verdict and reason.
///
/// @param all_matches  the matches were not filtered, so that their number proves little: the pose
///   is doubtful where the surfaces meet, and never trusted.
void judge(CloudResult& result, bool all_matches);

}  // namespace gmcr
