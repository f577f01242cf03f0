#pragma once

#include <optional>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Transform that most of the putative correspondences source.col(i) -> target.col(i) agree with.
///
/// Maximises the evidence of { i : |target_i - (s R source_i + t)| <= noise_bound_i }
/// (Gentner et al. 2023, Eq. (2)) by consistency graphs and maximum cliques, and bounds from
/// above how many inliers any transform can have.
/// @param source, target  3 x N, the same N, metres; coordinates are 0 or of a magnitude from
///   `kLeastMagnitude` to `kLargestMagnitude`.
/// @return status, transform, inliers, certificate and diagnostics.
/// @throws std::invalid_argument on a shape mismatch, a value out of range, or a bad option, before
///   any work.
/// Cost: O(N^2) time and N^2 / 8 bytes for the graph, O(N) and that of a sample where memory or
/// time is far from sufficing for it; the clique search is exponential in the worst case and
/// bounded by `options.time_limit`; `NoiseMode::Estimated` adds about 11 cheap solves.
/// Deterministic for any thread count unless the time binds.
Result register_correspondences(const PointsRef& source, const PointsRef& target,
                                const Options& options);

/// When the search for further instances ends.
struct InstanceOptions {
  int max_instances = 10;            ///< >= 1
  Index min_instance_inliers = 8;    ///< >= 3: an instance needs that many
  double min_instance_share = 0.25;  ///< in [0, 1]: and that share of the evidence of the first one

  /// @throws InvalidOption naming option and value.
  void validate() const;
};

/// Several instances of the source in the target: registers, removes the consensus set, registers
/// what is left, and so on.
///
/// @param source, target, options  as for `register_correspondences`; `options.time_limit` is for
///   all of them together.
/// @return the instances found, in that order; the first whatever it holds, so never empty. The
///   inliers of the others are those that no earlier one has, as indices into the caller's input;
///   their certificates speak of what was left.
/// @throws std::invalid_argument as `register_correspondences`, and on a bad instance option.
/// Cost: one registration an instance.
std::vector<Result> register_instances(const PointsRef& source, const PointsRef& target,
                                       const Options& options,
                                       const InstanceOptions& instances = {});

/// The correspondences that agree with a transform, and the evidence that they are.
struct Consensus {
  std::vector<Index> inliers;  ///< ascending
  double evidence = 0;         ///< as in `Result`
};

/// Consensus set of a given transform, by the same rules as `Result::inliers`: for a pose that was
/// refined or comes from elsewhere.
/// @param source, target, options  as for `register_correspondences`.
/// @throws std::invalid_argument as `register_correspondences`, and where the noise is to be
///   estimated.
/// Cost O(N log N) where few target points are near each other.
Consensus evaluate_consensus(const Similarity& target_from_source, const PointsRef& source,
                             const PointsRef& target, const Options& options);

/// How surely correspondences determine a transform.
struct Uncertainty {
  ScaleRange consistent_scales{1, 1};    ///< as in `Result`
  std::optional<Covariance> covariance;  ///< nullopt where the transform is one of many that fit
};

/// Uncertainty of a given transform, by the same rules as in `Result`.
/// @param source, target, options  as for `register_correspondences`; `options.time_limit` ends
///   the intersection of the scales, which is wider then.
/// @param inliers  its consensus set (`evaluate_consensus`), indices into the input.
/// @throws std::invalid_argument as `evaluate_consensus`, and on an index out of range.
/// Cost O(m log m) for m inliers; where the scale is estimated and all residuals are far below
/// their bounds up to O(m^2), a few ns each.
Uncertainty evaluate_uncertainty(const Similarity& target_from_source, const PointsRef& source,
                                 const PointsRef& target, const std::vector<Index>& inliers,
                                 const Options& options);

/// The graph whose edges are the pairs of correspondences that can be inliers of one transform:
/// those that agree at a scale that the options admit and that the priors and one-to-one leave. The
/// consensus set of every admitted transform is a clique of it.
///
/// @param source, target, options  as for `register_correspondences`; where the scale is estimated,
///   `options.scale_range` says between which scales.
/// @return a graph over all correspondences; what the priors exclude has no edge.
/// @throws std::invalid_argument as `evaluate_consensus`, and where the scale is estimated without
///   a range.
/// Cost O(N^2) time, N^2 / 8 bytes.
BitsetGraph consistency_graph(const PointsRef& source, const PointsRef& target,
                              const Options& options);

}  // namespace gmcr
