#pragma once

#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "kernels/consistency_row.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::problem {

/// The correspondences laid out for the consistency kernel, with bounds widened by the rounding of
/// residuals at scales up to `scale_max`: two inliers of one pose are never without an edge.
kernels::CorrespondenceArrays consistency_arrays(const Correspondences& correspondences,
                                                 double scale_max);

/// Graph whose edges are the pairs that agree at some scale of `scales` (L1, L5).
///
/// The consensus set of every transform with a scale in the range is a clique of it.
/// Where the deadline passes first, edges are missing: cliques are cliques still, bounds mean
/// nothing. Cost O(N^2), memory N^2 / 8 bytes.
BitsetGraph consistency_graph(const kernels::CorrespondenceArrays& arrays, const ScaleRange& scales,
                              int num_threads,
                              const parallel::Deadline& deadline = parallel::Deadline::never());

}  // namespace gmcr::problem
