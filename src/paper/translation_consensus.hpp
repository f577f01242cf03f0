#pragma once

#include <Eigen/Core>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::paper {

/// Graph whose edges are the pairs of measurements t_i = b_i - s R a_i that share a translation
/// (L4): |t_i - t_j| <= eps_i + eps_j (paper, eq:corresp_est:translation_consensus_funct).
/// @param measurements  3 x N, metres.  @param bounds  N inlier bounds, metres.
/// @return a graph without edges where the deadline passes first.
/// Cost O(N^2), memory N^2 / 8 bytes.
BitsetGraph translation_graph(const PointsRef& measurements, const Eigen::ArrayXd& bounds,
                              int num_threads,
                              const parallel::Deadline& deadline = parallel::Deadline::never());

}  // namespace gmcr::paper
