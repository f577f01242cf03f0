#include "paper/translation_consensus.hpp"

#include <span>

#include "estimation/closed_forms/translation.hpp"
#include "problem/graph/graph_rows.hpp"

namespace gmcr::paper {

BitsetGraph translation_graph(const PointsRef& measurements, const Eigen::ArrayXd& bounds,
                              int num_threads, const parallel::Deadline& deadline) {
  return problem::graph_from_rows(
      measurements.cols(), num_threads, deadline, [&](Index i, std::span<std::uint64_t> row) {
        for (Index j = 0; j < measurements.cols(); ++j) {
          // Eq. (16), L4: |t_i - t_j| <= eps_i + eps_j
          const Eigen::Array3d squares =
              (measurements.col(j) - measurements.col(i)).array().square();
          const double bound = bounds[i] + bounds[j];
          const bool meet = squares[0] + squares[1] + squares[2] <= bound * bound;
          row[static_cast<std::size_t>(j / 64)] |= std::uint64_t{meet && j != i} << (j % 64);
        }
      });
}

TranslationConsensus translation_consensus(problem::Run& run, const problem::Correspondences& all,
                                           const std::vector<Index>& indices, double scale,
                                           const Eigen::Matrix3d& rotation,
                                           std::uint64_t max_clique_nodes) {
  const problem::Correspondences some = problem::subset(all, indices);
  // t_i = b_i - s R a_i
  const Points measurements = some.target - scale * (rotation * some.source);
  const BitsetGraph graph =
      translation_graph(measurements, some.bounds, run.options().num_threads, run.deadline());
  const auto clique = run.max_clique(graph, 0, max_clique_nodes);
  TranslationConsensus consensus;
  consensus.proven = clique.proven;
  for (const Index vertex : clique.vertices) {
    consensus.correspondences.push_back(indices[static_cast<std::size_t>(vertex)]);
  }
  // Eq. (2) without outliers, at s and R: min_t sum_i |t - t_i|^2 / eps_i^2
  consensus.translation = estimation::estimate_translation(
      measurements(Eigen::all, clique.vertices), some.bounds(clique.vertices));
  return consensus;
}

}  // namespace gmcr::paper
