#include "paper/scale_consensus.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/rotation.hpp"
#include "estimation/scale.hpp"
#include "estimation/translation.hpp"
#include "paper/interval_sweep.hpp"
#include "paper/rotation_consensus.hpp"
#include "paper/translation_consensus.hpp"

namespace gmcr::paper {
namespace {

problem::SolveContext::Clique stage_clique(problem::SolveContext& context, const BitsetGraph& graph,
                                           std::uint64_t max_clique_nodes) {
  return context.max_clique(graph, 0, max_clique_nodes);
}

}  // namespace

std::optional<ScaleConsensus> scale_consensus(const Tims& tims, const ScaleRange& scales) {
  const ScaleMeasurements measurements = measure_scales(tims);
  ScaleConsensus consensus;
  consensus.tims =
      deepest_point(measurements.lower.max(scales.min), measurements.upper.min(scales.max)).members;
  const double scale = estimation::estimate_scale(measurements.scale(consensus.tims),
                                                  measurements.alpha(consensus.tims));
  if (!std::isfinite(scale)) return std::nullopt;
  consensus.scale = std::clamp(scale, scales.min, scales.max);
  return consensus;
}

std::optional<RotationConsensus> rotation_consensus(problem::SolveContext& context,
                                                    const Tims& tims, double scale,
                                                    std::uint64_t max_clique_nodes) {
  const RotationCones cones = rotation_cones(tims, scale);
  const BitsetGraph graph =
      rotation_graph(cones, context.options().num_threads, context.deadline());
  const auto clique = stage_clique(context, graph, max_clique_nodes);
  RotationConsensus consensus;
  consensus.proven = clique.proven;
  for (const Index vertex : clique.vertices) {
    consensus.tims.push_back(cones.tims[static_cast<std::size_t>(vertex)]);
  }
  const auto rotation = estimation::estimate_rotation(tims.source(Eigen::all, consensus.tims),
                                                      tims.target(Eigen::all, consensus.tims));
  if (!rotation) return std::nullopt;
  consensus.rotation = *rotation;
  return consensus;
}

TranslationConsensus translation_consensus(problem::SolveContext& context,
                                           const problem::Correspondences& all,
                                           const std::vector<Index>& indices, double scale,
                                           const Eigen::Matrix3d& rotation,
                                           std::uint64_t max_clique_nodes) {
  const problem::Correspondences some = problem::subset(all, indices);
  const Points measurements = some.target - scale * (rotation * some.source);
  const BitsetGraph graph = translation_graph(measurements, some.bounds,
                                              context.options().num_threads, context.deadline());
  const auto clique = stage_clique(context, graph, max_clique_nodes);
  TranslationConsensus consensus;
  consensus.proven = clique.proven;
  for (const Index vertex : clique.vertices) {
    consensus.correspondences.push_back(indices[static_cast<std::size_t>(vertex)]);
  }
  consensus.translation = estimation::estimate_translation(
      measurements(Eigen::all, clique.vertices), some.bounds(clique.vertices));
  return consensus;
}

std::vector<Index> touched_correspondences(const Tims& tims, const std::vector<Index>& indices) {
  std::vector<Index> touched;
  for (const Index k : indices) {
    touched.push_back(tims.pairs[static_cast<std::size_t>(k)].first);
    touched.push_back(tims.pairs[static_cast<std::size_t>(k)].second);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

Tims select(const Tims& tims, const std::vector<Index>& indices) {
  Tims selected;
  for (const Index k : indices) selected.pairs.push_back(tims.pairs[static_cast<std::size_t>(k)]);
  selected.source = tims.source(Eigen::all, indices);
  selected.target = tims.target(Eigen::all, indices);
  selected.bounds = tims.bounds(indices);
  return selected;
}

}  // namespace gmcr::paper
