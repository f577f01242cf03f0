#pragma once

#include <Eigen/Core>

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/options.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::registration {

/// Scales at which all pairs of the given correspondences agree (L1): the intersection of the
/// pairs' scale intervals.
///
/// A pair of residuals r_i, r_j leaves the scale at least  (eps_i - r_i + eps_j - r_j) / |a_j -
/// a_i| of room on both sides, so once some pairs have narrowed the range most others cannot.
/// @param inliers    consensus set of a transform of scale `scale`.
/// @param residuals  of the inliers under that transform, metres, each within its bound.
/// @param deadline   where it passes, only a part of the pairs is intersected: the range is wider
///   then, not wrong.
/// @return a range that contains `scale`; 0 to infinity where no pair has a length.
/// Cost O(m log m) and few pairs a point where the residuals vary up to the bound, up to m^2 / 2
/// pairs, a few ns each, where all are much smaller. Deterministic for any number of threads unless
/// the deadline passes.
ScaleRange consistent_scales(const geometry::CorrespondenceArrays& inliers,
                             const Eigen::ArrayXd& residuals, double scale, int num_threads,
                             const parallel::Deadline& deadline);

}  // namespace gmcr::registration
