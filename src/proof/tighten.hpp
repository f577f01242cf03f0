#pragma once

#include "parallel/deadline.hpp"
#include "search/incumbent.hpp"

namespace gmcr::proof {

/// Time that the options let the bounds on a measure be tightened: none unless they ask for it,
/// else half of what is left for the evidence, and all of it for the number of inliers, less what
/// further hypotheses need.
parallel::Deadline certify_deadline(search::PoseSearch& search, search::Measure measure);

/// Lowers an upper bound on the measure of poses in a range by the joint search until it meets what
/// was achieved or the time is up; offers the better poses that it meets.
double tighten(search::PoseSearch& search, const search::RangeGraph& range, search::Measure measure,
               double upper_bound, const parallel::Deadline& deadline);

}  // namespace gmcr::proof
