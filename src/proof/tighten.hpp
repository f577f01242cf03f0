#pragma once

#include "search/best_poses.hpp"

namespace gmcr::proof {

/// `Options::certify`: lowers the upper bounds of a search by searches over consensus sets until
/// they meet what was achieved or the time is up; keeps the better poses that these meet.
///
/// Half of the time that is left is for the evidence, the rest for the number of inliers, less what
/// further hypotheses need.
void tighten(search::BestPoseSearch& search);

}  // namespace gmcr::proof
