#pragma once

#include "registration/range_search.hpp"

namespace gmcr {

/// Where the options ask for it, lowers the bounds of a range by the joint search until they meet
/// what was achieved or the time is up; offers the better poses that it meets.
UpperBounds tighten(PoseSearch& search, const RangeGraph& range, UpperBounds bounds);

/// The same for one measure.
double tighten(PoseSearch& search, const RangeGraph& range, Measure measure, double upper_bound);

}  // namespace gmcr
