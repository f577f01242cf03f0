#pragma once

#include "parallel/deadline.hpp"
#include "registration/range_search.hpp"

namespace gmcr {

/// Time that the options let the bounds on a measure be tightened: none unless they ask for it,
/// else half of what is left for the evidence, and all of it for the number of inliers, less what
/// further hypotheses need.
Deadline certify_deadline(PoseSearch& search, Measure measure);

/// Lowers an upper bound on the measure of poses in a range by the joint search until it meets what
/// was achieved or the time is up; offers the better poses that it meets.
double tighten(PoseSearch& search, const RangeGraph& range, Measure measure, double upper_bound,
               const Deadline& deadline);

}  // namespace gmcr
