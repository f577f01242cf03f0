#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "consensus/pair_filter.hpp"
#include "estimation/admitted.hpp"
#include "estimation/pose_constraints.hpp"
#include "estimation/spread.hpp"
#include "gmcr/registration.hpp"
#include "invariants/correspondences.hpp"
#include "parallel/parallel_for.hpp"
#include "registration/certificate.hpp"
#include "registration/gmcr_method.hpp"
#include "registration/objective.hpp"
#include "registration/paper_method.hpp"
#include "registration/scale_search.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {
namespace {

constexpr Index kMinInliers = 3;

void validate_input(const PointsRef& source, const PointsRef& target, const Options& options) {
  options.validate();
  if (source.cols() != target.cols()) {
    throw std::invalid_argument("target: " + std::to_string(target.cols()) +
                                " points, but source has " + std::to_string(source.cols()));
  }
  const auto num_bounds = static_cast<Index>(options.noise_bounds.size());
  if (num_bounds != 0 && num_bounds != source.cols()) {
    throw std::invalid_argument("noise_bounds: " + std::to_string(num_bounds) + " values for " +
                                std::to_string(source.cols()) + " correspondences");
  }
  for (const auto& [name, points] : {std::pair<const char*, const PointsRef&>{"source", source},
                                     std::pair<const char*, const PointsRef&>{"target", target}}) {
    for (Index i = 0; i < points.cols(); ++i) {
      if (points.col(i).allFinite()) continue;
      throw std::invalid_argument(std::string(name) + ": point " + std::to_string(i) +
                                  " is not finite");
    }
  }
}

/// eps_i = beta_i / c (paper, eq:consensus_set).
Eigen::ArrayXd inlier_bounds(const Options& options, Index count) {
  if (options.noise_bounds.empty()) {
    return Eigen::ArrayXd::Constant(count, options.noise_bound / options.threshold);
  }
  return Eigen::Map<const Eigen::ArrayXd>(options.noise_bounds.data(), count) / options.threshold;
}

/// The input as it is, in the caller's frames.
Correspondences correspondences_of(const PointsRef& source, const PointsRef& target,
                                   const Options& options) {
  Correspondences input;
  input.source = source;
  input.target = target;
  input.bounds = inlier_bounds(options, source.cols());
  return input;
}

std::vector<Index> indices_below(Index count) {
  std::vector<Index> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

/// The correspondences that the priors on the translation admit, ascending.
std::vector<Index> admitted_correspondences(const Correspondences& centred, const Options& options,
                                            const ScaleRange& scales) {
  std::vector<Index> admitted = indices_below(centred.size());
  const PairFilter filter(centred, options.priors, false, scales);
  std::erase_if(admitted, [&](Index i) { return !filter.admits(i, scales); });
  return admitted;
}

/// Bound on all inliers of a pose from one on those of which no two share a point.
///
/// Let nu(S) be the size of a largest one-to-one subset of S. Adding a correspondence to S raises
/// nu by at most 1, so |S| - nu(S) never falls as S grows: |S| <= nu(S) + |all| - nu(all), and any
/// one-to-one subset of all has at most nu(all).
Index bound_on_all(Index upper_bound, Index num_used, const PairFilter& filter) {
  return std::min(num_used,
                  upper_bound + num_used - filter.count_one_to_one(indices_below(num_used)));
}

/// Why the inliers do not determine the transform; empty where they do.
///
/// Points that stay within half the noise bound when turned about a line, or scaled about a point,
/// say nothing about that turn or scale.
std::string degeneracy_reason(const Points& source, const Similarity& pose,
                              const std::vector<Index>& inliers, double bound,
                              const Priors& priors) {
  constexpr double kKnownAxis = std::numbers::pi / 180;
  const Spread spread = measure_spread(source, inliers);
  const double tolerance = std::max(bound / 2, 1e-9 * pose.scale * spread.from_centroid);
  if (pose.scale * spread.from_centroid <= tolerance) {
    return "the inliers coincide within the noise bound: rotation and scale are not determined";
  }
  if (priors.gravity && priors.gravity->max_tilt <= kKnownAxis) {
    // only the rotation about gravity is left, which points off the line along it determine
    const double reach = reach_from_line(source, inliers, priors.gravity->source);
    if (pose.scale * reach > tolerance) return {};
    return "the inliers are on a line along gravity within the noise bound: the rotation about it "
           "is not determined";
  }
  if (pose.scale * spread.from_line <= tolerance) {
    return "the inliers are collinear within the noise bound: the rotation about their line is not "
           "determined";
  }
  return {};
}

/// Fills transform, inliers, certificate and status from a pose between the caller's frames, judged
/// on all of the caller's correspondences: these residuals are what the caller can check.
/// @param objective  of the correspondences that were used, for their weights where these are all.
void conclude(Result& result, const Similarity& pose, Index upper_bound,
              const Correspondences& input, const Objective& objective, const Options& options) {
  const bool all_used = objective.correspondences().size() == input.size();
  const Evidence evidence = all_used ? Evidence::Count : options.evidence;
  Hypothesis judged = Objective(input, evidence, options.budget.memory / 4).judge(pose);
  if (all_used) judged.evidence = objective.evidence_of(judged.inliers, pose.scale);
  result.certificate = certify(judged.num_inliers(), upper_bound);
  if (judged.num_inliers() < kMinInliers) {
    result.status = Status::NoConsensus;
    result.status_reason = "no pose found has 3 inliers";
    return;
  }
  result.target_from_source = pose;
  result.inliers = judged.inliers;
  result.evidence = judged.evidence;
  result.status_reason = degeneracy_reason(input.source, pose, judged.inliers,
                                           input.bounds(judged.inliers).maxCoeff(), options.priors);
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
}

ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(default_scale_range(correspondences));
}

std::string no_pose_reason(const Diagnostics& diagnostics, const Options& options) {
  if (!diagnostics.limits_hit.empty()) return "no pose was found before a limit ended the search";
  return options.priors.empty() ? "no three correspondences agree on a pose"
                                : "no three correspondences agree on a pose that the priors admit, "
                                  "as far as was found";
}

}  // namespace

Result register_correspondences(const PointsRef& source, const PointsRef& target,
                                const Options& options) {
  validate_input(source, target, options);
  Result result;
  SolveContext context(options, result.diagnostics);
  const Deadline clock(0);
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.num_correspondences = diagnostics.num_used = source.cols();
  diagnostics.num_threads = resolve_num_threads(options.num_threads);
  const auto give_up = [&](Status status, const std::string& reason, Index upper_bound) {
    result.status = status;
    result.status_reason = reason;
    result.certificate = certify(0, upper_bound);
    diagnostics.total_seconds = clock.elapsed();
    return result;
  };
  if (source.cols() < kMinInliers) {
    return give_up(Status::TooFewCorrespondences,
                   std::to_string(source.cols()) + " correspondences; 3 are needed", source.cols());
  }

  const Correspondences input = correspondences_of(source, target, options);
  Correspondences centred = centre(input.source, input.target, input.bounds);
  const ScaleRange scales = scales_to_search(options, centred);
  diagnostics.scale_range = scales;
  const std::vector<Index> used = admitted_correspondences(centred, options, scales);
  diagnostics.num_used = static_cast<Index>(used.size());
  if (diagnostics.num_used < kMinInliers) {
    return give_up(Status::NoConsensus,
                   "the priors on the translation admit " + std::to_string(used.size()) +
                       " correspondences; 3 are needed",
                   diagnostics.num_used);
  }
  context.require_memory_for_graph(diagnostics.num_used);
  if (diagnostics.num_used < input.size()) {
    const Correspondences kept = subset(input, used);
    centred = centre(kept.source, kept.target, kept.bounds);
  }

  const Objective objective = [&] {
    const StageTimer timer(context, "evidence");
    return Objective(centred, options.evidence, options.budget.memory / 4);
  }();
  if (!objective.weights_complete()) {
    context.limit("the memory budget does not suffice for distinct evidence: inliers were counted");
  }
  const PoseConstraints constraints{scales, options.priors, centred.source_origin,
                                    centred.target_origin};
  const PairFilter filter(centred, options.priors, options.one_to_one, scales);
  const MethodResult found = options.method == Method::Gmcr
                                 ? solve_gmcr(context, objective, constraints, filter)
                                 : solve_paper(context, centred, constraints, filter);
  const Index upper_bound = bound_on_all(found.upper_bound, diagnostics.num_used, filter);
  const auto pose =
      found.target_from_source
          ? admitted_pose(uncentre(*found.target_from_source, centred), options.priors)
          : std::nullopt;
  if (!pose) {
    return give_up(Status::NoConsensus, no_pose_reason(diagnostics, options), upper_bound);
  }
  conclude(result, *pose, upper_bound, input, objective, options);
  diagnostics.total_seconds = clock.elapsed();
  return result;
}

Consensus evaluate_consensus(const Similarity& target_from_source, const PointsRef& source,
                             const PointsRef& target, const Options& options) {
  validate_input(source, target, options);
  const Correspondences input = correspondences_of(source, target, options);
  const Hypothesis judged =
      Objective(input, options.evidence, options.budget.memory / 4).judge(target_from_source);
  return {judged.inliers, judged.evidence};
}

}  // namespace gmcr
