#include "paper/rotation_consensus.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "estimation/closed_forms/rotation.hpp"
#include "problem/graph/graph_rows.hpp"
#include "problem/graph/symmetric_blocks.hpp"

namespace gmcr::paper {
namespace {

/// Cosine of the half-angle of the cone that a TIM admits; nullopt where it admits none.
std::optional<double> cone_cosine(double source_length, double target_length, double bound) {
  // L3: every rotation suits, gamma_k = pi
  if (bound >= source_length + target_length) return -1.0;
  // L1 fails: no rotation suits
  if (std::abs(target_length - source_length) > bound) return std::nullopt;
  // Eq. (12), (13), L3: |bbar - s R abar|^2 = |bbar|^2 + |s abar|^2 - 2 |bbar| |s abar| cos(angle)
  // is at most eps^2 iff angle(bbar, R abar) <= gamma
  const double cosine =
      (target_length * target_length + source_length * source_length - bound * bound) /
      (2 * source_length * target_length);
  return std::clamp(cosine, -1.0, 1.0);
}

Eigen::RowVector3d direction(const Eigen::Vector3d& vector, double length) {
  // a vector of length 0 has a cone of pi: any direction will do
  return length > 0 ? (vector / length).transpose().eval() : Eigen::RowVector3d(1, 0, 0);
}

}  // namespace

RotationCones rotation_cones(const Tims& tims, double scale) {
  RotationCones cones;
  std::vector<double> cosines;
  for (Index k = 0; k < tims.size(); ++k) {
    const auto cosine =
        cone_cosine(scale * tims.source.col(k).norm(), tims.target.col(k).norm(), tims.bounds[k]);
    if (!cosine) continue;
    cones.tims.push_back(k);
    cosines.push_back(*cosine);
  }
  const auto count = static_cast<Index>(cosines.size());
  kernels::DirectionArrays& directions = cones.directions;
  directions.cos_gamma = Eigen::Map<const Eigen::ArrayXd>(cosines.data(), count);
  directions.sin_gamma = (1 - directions.cos_gamma.square()).max(0).sqrt();
  directions.source.resize(count, 3);
  directions.target.resize(count, 3);
  for (Index row = 0; row < count; ++row) {
    const Index k = cones.tims[static_cast<std::size_t>(row)];
    directions.source.row(row) = direction(tims.source.col(k), tims.source.col(k).norm());
    directions.target.row(row) = direction(tims.target.col(k), tims.target.col(k).norm());
  }
  return cones;
}

BitsetGraph rotation_graph(const RotationCones& cones, int num_threads,
                           const parallel::Deadline& deadline) {
  BitsetGraph graph = problem::graph_from_rows(
      cones.directions.size(), num_threads, deadline, [&](Index k, std::span<std::uint64_t> row) {
        // Eq. (15), L3: |angle(abar_k, abar_l) - angle(bbar_k, bbar_l)| <= gamma_k + gamma_l
        kernels::rotation_row(cones.directions, k, row, k / BitsetGraph::kBitsPerWord);
      });
  problem::mirror_upper_blocks(graph, num_threads, deadline);
  return graph;
}

std::optional<RotationConsensus> rotation_consensus(problem::Run& run, const Tims& tims,
                                                    double scale, std::uint64_t max_clique_nodes) {
  const RotationCones cones = rotation_cones(tims, scale);
  const BitsetGraph graph = rotation_graph(cones, run.options().num_threads, run.deadline());
  const auto clique = run.max_clique(graph, 0, max_clique_nodes);
  RotationConsensus consensus;
  consensus.proven = clique.proven;
  for (const Index vertex : clique.vertices) {
    consensus.tims.push_back(cones.tims[static_cast<std::size_t>(vertex)]);
  }
  // Eq. (5) without outliers: min_R sum_k |bbar_k - R abar_k|^2
  const auto rotation = estimation::estimate_rotation(tims.source(Eigen::all, consensus.tims),
                                                      tims.target(Eigen::all, consensus.tims));
  if (!rotation) return std::nullopt;
  consensus.rotation = *rotation;
  return consensus;
}

}  // namespace gmcr::paper
