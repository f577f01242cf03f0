#pragma once

#include "gmcr/options.hpp"
#include "kernels/consistency_row.hpp"
#include "parallel/deadline.hpp"

namespace gmcr {

/// Scales at which all pairs of the given correspondences agree (L1): the intersection of the
/// pairs' scale intervals.
///
/// @param inliers  consensus set of a transform of scale `scale`, so that each interval holds it,
///   to rounding.
/// @param deadline  where it passes, only a part of the pairs is intersected: the range is wider
///   then, not wrong.
/// @return a range that contains `scale`; its end is infinite where no pair has a length.
/// Cost O(m^2) for m correspondences, 1 to 2 ns a pair. Deterministic for any number of threads
/// unless the deadline passes.
ScaleRange consistent_scales(const kernels::CorrespondenceArrays& inliers, double scale,
                             int num_threads, const Deadline& deadline);

}  // namespace gmcr
