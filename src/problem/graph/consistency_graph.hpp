#pragma once

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::problem {

/// Metres by which a residual of each correspondence may be off by rounding at scales up to
/// `scale_max`, at least; the same of all where it is small beside every bound.
Eigen::ArrayXd rounding_of_residuals(const Correspondences& correspondences, double scale_max);

/// The correspondences laid out for the consistency kernel, with bounds widened by the rounding of
/// their residuals: two inliers of one pose are never without an edge.
geometry::CorrespondenceArrays consistency_arrays(const Correspondences& correspondences,
                                                  double scale_max);

/// Graph whose edges are the pairs that agree at some scale of `scales` (L1, L5).
///
/// The consensus set of every transform with a scale in the range is a clique of it.
/// Where the deadline passes first, edges are missing: cliques are cliques still, bounds mean
/// nothing. Cost O(N^2), memory N^2 / 8 bytes.
BitsetGraph consistency_graph(const geometry::CorrespondenceArrays& arrays,
                              const ScaleRange& scales, int num_threads,
                              const parallel::Deadline& deadline = parallel::Deadline::never());

}  // namespace gmcr::problem
