#include <stdexcept>
#include <string>
#include <vector>

#include "gmcr/registration.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "problem/graph/pair_filter.hpp"
#include "problem/input.hpp"
#include "problem/objective/objective.hpp"
#include "problem/scales.hpp"
#include "registration/judgement/degeneracy.hpp"
#include "registration/judgement/uncertainty.hpp"

namespace gmcr {
namespace {

/// A given pose is judged by a given bound.
void require_given_noise(const Options& options) {
  if (options.noise_mode == NoiseMode::Given) return;
  throw InvalidOption("noise_mode", "is 'estimated', but a given pose needs a noise bound");
}

/// @throws std::invalid_argument where a pose is none, or of other magnitudes than a solve takes.
void require_pose(const Similarity& pose) {
  if (!(pose.scale > 0 && pose.matrix().allFinite())) {
    throw std::invalid_argument("target_from_source: is not finite, or its scale is not positive");
  }
  if (pose.scale >= kLeastMagnitude && pose.scale <= kLargestMagnitude &&
      pose.translation.cwiseAbs().maxCoeff() <= kLargestMagnitude) {
    return;
  }
  throw std::invalid_argument(
      "target_from_source: its scale is not in [1e-50, 1e50], or its translation above 1e50");
}

/// The graph less the edges of all vertices but the given ones, ascending.
BitsetGraph without_other_vertices(const BitsetGraph& graph, const std::vector<Index>& vertices) {
  BitsetGraph some(graph.num_vertices());
  for (const Index u : vertices) {
    for (const Index v : vertices) {
      if (v == u) break;
      if (graph.has_edge(u, v)) some.add_edge(u, v);
    }
  }
  return some;
}

}  // namespace

Consensus evaluate_consensus(const Similarity& target_from_source, const PointsRef& source,
                             const PointsRef& target, const Options& options) {
  problem::validate_input(source, target, options);
  require_given_noise(options);
  require_pose(target_from_source);
  const problem::CallerCorrespondences input{source, target,
                                             problem::inlier_bounds(options, source.cols())};
  const problem::CallerObjective objective(
      input, options.evidence, options.memory_limit / 4,
      ScaleRange{target_from_source.scale, target_from_source.scale},
      problem::scale_buckets_of(options, source, target));
  const problem::CallerHypothesis judged = objective.judge({target_from_source});
  return {judged.inliers, judged.evidence};
}

Uncertainty evaluate_uncertainty(const Similarity& target_from_source, const PointsRef& source,
                                 const PointsRef& target, const std::vector<Index>& inliers,
                                 const Options& options) {
  problem::validate_input(source, target, options);
  require_given_noise(options);
  require_pose(target_from_source);
  for (const Index i : inliers) {
    if (i >= 0 && i < source.cols()) continue;
    throw std::invalid_argument("inliers: " + std::to_string(i) + " is not one of " +
                                std::to_string(source.cols()) + " correspondences");
  }
  const problem::CallerCorrespondences input{source, target,
                                             problem::inlier_bounds(options, source.cols())};
  Uncertainty uncertainty =
      registration::measure_uncertainty({target_from_source}, input, inliers, options,
                                        parallel::Deadline(options.time_limit, options.stop));
  const bool determined =
      uncertainty.covariance && registration::degeneracy_reason(source, target_from_source, inliers,
                                                                input.bounds(inliers), options)
                                    .empty();
  if (!determined) uncertainty.covariance.reset();
  return uncertainty;
}

BitsetGraph consistency_graph(const PointsRef& source, const PointsRef& target,
                              const Options& options) {
  problem::validate_input(source, target, options);
  require_given_noise(options);
  const problem::Correspondences centred =
      problem::centre(source, target, problem::inlier_bounds(options, source.cols()));
  if (options.scale_mode == ScaleMode::Estimated && !options.scale_range) {
    throw std::invalid_argument("scale_range: the graph of an unknown scale needs one");
  }
  const ScaleRange scales = problem::scales_to_search(options, centred);
  BitsetGraph graph = problem::consistency_graph(problem::consistency_arrays(centred, scales.max),
                                                 scales, options.num_threads);
  const problem::PairFilter filter(centred, options, options.one_to_one, scales);
  filter.apply(graph, scales, options.num_threads);
  std::vector<Index> admitted;
  for (Index i = 0; i < graph.num_vertices(); ++i) {
    if (filter.admits(i, scales)) admitted.push_back(i);
  }
  return static_cast<Index>(admitted.size()) == graph.num_vertices()
             ? graph
             : without_other_vertices(graph, admitted);
}

}  // namespace gmcr
