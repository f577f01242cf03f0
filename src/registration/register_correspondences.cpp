#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

#include "estimation/spread.hpp"
#include "gmcr/registration.hpp"
#include "invariants/correspondences.hpp"
#include "parallel/parallel_for.hpp"
#include "registration/certificate.hpp"
#include "registration/gmcr_method.hpp"
#include "registration/noise_estimation.hpp"
#include "registration/objective.hpp"
#include "registration/paper_method.hpp"
#include "registration/scale_search.hpp"
#include "registration/solve_context.hpp"
#include "registration/uncertainty.hpp"

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

/// A given pose is judged by a given bound.
void require_given_noise(const Options& options) {
  if (options.noise_mode == NoiseMode::Given) return;
  throw std::invalid_argument("noise_mode: is Estimated, but a given pose needs a noise bound");
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

/// The correspondences none of whose end points an earlier one has, ascending.
std::vector<Index> first_of_each_point(const PointsRef& source, const PointsRef& target) {
  using Key = std::tuple<double, double, double>;
  const auto key = [](const PointsRef& points, Index i) {
    return Key{points(0, i), points(1, i), points(2, i)};
  };
  std::map<Key, Index> first_of_source, first_of_target;
  std::vector<Index> kept;
  for (Index i = 0; i < source.cols(); ++i) {
    const Key a = key(source, i), b = key(target, i);
    if (first_of_source.contains(a) || first_of_target.contains(b)) continue;
    first_of_source.emplace(a, i);
    first_of_target.emplace(b, i);
    kept.push_back(i);
  }
  return kept;
}

std::vector<Index> used_correspondences(const PointsRef& source, const PointsRef& target,
                                        bool one_to_one) {
  if (one_to_one) return first_of_each_point(source, target);
  std::vector<Index> all(static_cast<std::size_t>(source.cols()));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// Why the inliers do not determine the transform; empty where they do.
///
/// Points that stay within half the noise bound when turned about a line, or scaled about a point,
/// say nothing about that turn or scale.
std::string degeneracy_reason(const Points& source, const Similarity& pose,
                              const std::vector<Index>& inliers, double bound) {
  const Spread spread = measure_spread(source, inliers);
  const double tolerance = std::max(bound / 2, 1e-9 * pose.scale * spread.from_centroid);
  if (pose.scale * spread.from_centroid <= tolerance) {
    return "the inliers coincide within the noise bound: rotation and scale are not determined";
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
                                           input.bounds(judged.inliers).maxCoeff());
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
}

/// Fills what the residuals of the inliers say of the transform.
void describe_uncertainty(Result& result, SolveContext& context, const Correspondences& input) {
  if (result.status != Status::Ok && result.status != Status::Degenerate) return;
  const StageTimer timer(context, "uncertainty");
  Uncertainty uncertainty = measure_uncertainty(result.target_from_source, input, result.inliers,
                                                context.options(), context.deadline());
  result.consistent_scales = uncertainty.consistent_scales;
  if (result.status == Status::Ok) result.covariance = std::move(uncertainty.covariance);
}

ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(default_scale_range(correspondences));
}

}  // namespace

Result register_correspondences(const PointsRef& source, const PointsRef& target,
                                const Options& options) {
  validate_input(source, target, options);
  if (options.noise_mode == NoiseMode::Estimated) {
    return register_with_estimated_noise(source, target, options);
  }
  Result result;
  SolveContext context(options, result.diagnostics);
  const Deadline clock(0);
  const std::vector<Index> used = used_correspondences(source, target, options.one_to_one);
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.num_correspondences = source.cols();
  diagnostics.num_used = static_cast<Index>(used.size());
  diagnostics.num_threads = resolve_num_threads(options.num_threads);
  if (diagnostics.num_used < kMinInliers) {
    result.status_reason = std::to_string(used.size()) + " correspondences; 3 are needed";
    result.certificate = certify(0, diagnostics.num_used);
    diagnostics.total_seconds = clock.elapsed();
    return result;
  }
  context.require_memory_for_graph(diagnostics.num_used);

  const Correspondences input = correspondences_of(source, target, options);
  const Correspondences centred = [&] {
    const Correspondences kept = subset(input, used);
    return centre(kept.source, kept.target, kept.bounds);
  }();
  const Objective objective = [&] {
    const StageTimer timer(context, "evidence");
    return Objective(centred, options.evidence, options.budget.memory / 4);
  }();
  if (!objective.weights_complete()) {
    context.limit("the memory budget does not suffice for distinct evidence: inliers were counted");
  }
  const ScaleRange scales = scales_to_search(options, centred);
  diagnostics.scale_range = scales;
  const MethodResult found = options.method == Method::Gmcr ? solve_gmcr(context, objective, scales)
                                                            : solve_paper(context, centred, scales);
  // a correspondence that was dropped may agree with a pose too
  const Index upper_bound =
      found.upper_bound + diagnostics.num_correspondences - diagnostics.num_used;
  if (found.target_from_source) {
    conclude(result, uncentre(*found.target_from_source, centred), upper_bound, input, objective,
             options);
    describe_uncertainty(result, context, input);
  } else {
    result.status = Status::NoConsensus;
    result.status_reason = diagnostics.limits_hit.empty()
                               ? "no three correspondences agree on a pose"
                               : "no pose was found before a limit ended the search";
    result.certificate = certify(0, upper_bound);
  }
  diagnostics.total_seconds = clock.elapsed();
  return result;
}

Consensus evaluate_consensus(const Similarity& target_from_source, const PointsRef& source,
                             const PointsRef& target, const Options& options) {
  validate_input(source, target, options);
  require_given_noise(options);
  const Correspondences input = correspondences_of(source, target, options);
  const Hypothesis judged =
      Objective(input, options.evidence, options.budget.memory / 4).judge(target_from_source);
  return {judged.inliers, judged.evidence};
}

Uncertainty evaluate_uncertainty(const Similarity& target_from_source, const PointsRef& source,
                                 const PointsRef& target, const std::vector<Index>& inliers,
                                 const Options& options) {
  validate_input(source, target, options);
  require_given_noise(options);
  for (const Index i : inliers) {
    if (i >= 0 && i < source.cols()) continue;
    throw std::invalid_argument("inliers: " + std::to_string(i) + " is not one of " +
                                std::to_string(source.cols()) + " correspondences");
  }
  const Correspondences input = correspondences_of(source, target, options);
  Uncertainty uncertainty = measure_uncertainty(target_from_source, input, inliers, options,
                                                Deadline(options.budget.time));
  const bool determined =
      uncertainty.covariance &&
      degeneracy_reason(source, target_from_source, inliers, input.bounds(inliers).maxCoeff())
          .empty();
  if (!determined) uncertainty.covariance.reset();
  return uncertainty;
}

}  // namespace gmcr
