#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "paper/tims.hpp"
#include "problem/correspondences.hpp"
#include "problem/run.hpp"

namespace gmcr::paper {

/// The stages of the paper (section "Graph-based Maximum Consensus Estimation"): each finds the
/// maximum clique of its consensus graph and estimates from it in closed form.

struct ScaleConsensus {
  double scale = 1;
  std::vector<Index> tims;  ///< TIMs of the clique, ascending
};

/// Scale stage by the interval sweep (L2) and the weighted mean.
/// @param scales  where the scale must lie.
/// @return nullopt where no TIM measures a scale in the range.
std::optional<ScaleConsensus> scale_consensus(const Tims& tims, const ScaleRange& scales);

struct RotationConsensus {
  Eigen::Matrix3d rotation;
  std::vector<Index> tims;  ///< TIMs of the clique, ascending
  bool proven = false;      ///< the clique is a maximum one
};

/// Rotation stage (L3, Arun et al. 1987); nullopt where the clique does not determine a rotation.
std::optional<RotationConsensus> rotation_consensus(problem::SolveContext& context,
                                                    const Tims& tims, double scale,
                                                    std::uint64_t max_clique_nodes);

struct TranslationConsensus {
  Eigen::Vector3d translation;
  std::vector<Index> correspondences;  ///< members of the clique, ascending
  bool proven = false;                 ///< the clique is a maximum one
};

/// Translation stage (L4, weighted mean) on the correspondences `indices` (at least one).
TranslationConsensus translation_consensus(problem::SolveContext& context,
                                           const problem::Correspondences& all,
                                           const std::vector<Index>& indices, double scale,
                                           const Eigen::Matrix3d& rotation,
                                           std::uint64_t max_clique_nodes);

/// Correspondences that the given TIMs touch, ascending.
std::vector<Index> touched_correspondences(const Tims& tims, const std::vector<Index>& indices);

/// The TIMs with the given numbers, in that order.
Tims select(const Tims& tims, const std::vector<Index>& indices);

}  // namespace gmcr::paper
