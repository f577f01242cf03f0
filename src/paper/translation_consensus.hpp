#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"
#include "problem/run.hpp"

namespace gmcr::paper {

/// Graph whose edges are the pairs of measurements t_i = b_i - s R a_i that share a translation:
/// the paper's translation consensus function, Eq. (16), L4.
/// @param measurements  3 x N, metres.  @param bounds  N inlier bounds, metres.
/// @return a graph without edges where the deadline passes first.
/// Cost O(N^2), memory N^2 / 8 bytes.
BitsetGraph translation_graph(const PointsRef& measurements, const Eigen::ArrayXd& bounds,
                              int num_threads,
                              const parallel::Deadline& deadline = parallel::Deadline::never());

/// What the translation stage finds.
struct TranslationConsensus {
  Eigen::Vector3d translation;
  std::vector<Index> correspondences;  ///< members of the clique, ascending
  bool proven = false;                 ///< the clique is a maximum one
};

/// Translation stage: the maximum clique of the translation graph and its weighted mean, on the
/// correspondences `indices` (at least one).
TranslationConsensus translation_consensus(problem::Run& run, const problem::Correspondences& all,
                                           const std::vector<Index>& indices, double scale,
                                           const Eigen::Matrix3d& rotation,
                                           std::uint64_t max_clique_nodes);

}  // namespace gmcr::paper
