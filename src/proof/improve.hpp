#pragma once

#include "search/best_poses.hpp"

namespace gmcr::proof {

/// Without `Options::certify`, among few matches: searches over consensus sets for a pose of more
/// evidence, where the bound leaves room for one; they lower the bound too.
///
/// Work is counted, so that the bits stay the same, and is a few milliseconds at most.
void improve(search::BestPoseSearch& search);

}  // namespace gmcr::proof
