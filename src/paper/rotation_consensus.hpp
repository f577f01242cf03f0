#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "kernels/pairs/rotation_row.hpp"
#include "paper/tims.hpp"
#include "parallel/deadline.hpp"
#include "problem/run.hpp"

namespace gmcr::paper {

/// TIMs that constrain the rotation at a given scale.
struct RotationCones {
  std::vector<Index> tims;              ///< which TIMs admit a rotation, ascending
  kernels::DirectionArrays directions;  ///< one row for each of them
};

/// Cone of rotations of each TIM (L3):
///   cos gamma_k = (|bbar_k|^2 + s^2 |abar_k|^2 - eps_k^2) / (2 s |abar_k| |bbar_k|),
/// gamma_k = pi where eps_k >= s |abar_k| + |bbar_k|. A TIM that fails L1 admits none and is left
/// out.
RotationCones rotation_cones(const Tims& tims, double scale);

/// Graph over the cones whose edges are the pairs of TIMs that share a rotation: the paper's
/// rotation consensus function, Eq. (15), by its definition.
///
/// Deviation: the paper tests two regions on the sphere, which admits 2 gamma_k + gamma_l; L3 is
/// exact. Cost O(K^2), memory K^2 / 8 bytes.
BitsetGraph rotation_graph(const RotationCones& cones, int num_threads,
                           const parallel::Deadline& deadline = parallel::Deadline::never());

/// What the rotation stage finds.
struct RotationConsensus {
  Eigen::Matrix3d rotation;
  std::vector<Index> tims;  ///< TIMs of the clique, ascending
  bool proven = false;      ///< the clique is a maximum one
};

/// Rotation stage: the maximum clique of the rotation graph and the best rotation for it (Arun et
/// al. 1987); nullopt where the clique does not determine a rotation.
std::optional<RotationConsensus> rotation_consensus(problem::Run& run, const Tims& tims,
                                                    double scale, std::uint64_t max_clique_nodes);

}  // namespace gmcr::paper
