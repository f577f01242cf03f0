#include <algorithm>
#include <numeric>
#include <string>

#include "consensus/pair_filter.hpp"
#include "estimation/admitted.hpp"
#include "estimation/pose_constraints.hpp"
#include "gmcr/registration.hpp"
#include "invariants/correspondences.hpp"
#include "parallel/parallel_for.hpp"
#include "registration/certificate.hpp"
#include "registration/conclude.hpp"
#include "registration/gmcr_method.hpp"
#include "registration/input.hpp"
#include "registration/least_squares.hpp"
#include "registration/noise_estimation.hpp"
#include "registration/objective.hpp"
#include "registration/paper_method.hpp"
#include "registration/scale_search.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {
namespace {

std::vector<Index> indices_below(Index count) {
  std::vector<Index> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

/// The correspondences that the priors on the translation admit, ascending.
std::vector<Index> admitted_correspondences(const Correspondences& centred, const Options& options,
                                            const ScaleRange& scales) {
  std::vector<Index> admitted = indices_below(centred.size());
  const PairFilter filter(centred, options, false, scales);
  std::erase_if(admitted, [&](Index i) { return !filter.admits(i, scales); });
  return admitted;
}

/// Bounds on all inliers of a pose from those on sets of which no two share a point.
///
/// Let nu(S) be the size of a largest one-to-one subset of S. Adding a correspondence to S raises
/// nu by at most 1, so |S| - nu(S) never falls as S grows: |S| <= nu(S) + |all| - nu(all), and any
/// one-to-one subset of all has at most nu(all). Each of the others gives evidence of at most 1.
void bound_all_inliers(MethodResult& found, Index num_used, const PairFilter& filter) {
  const std::vector<Index> one_to_one = filter.one_to_one(indices_below(num_used));
  const Index others = num_used - static_cast<Index>(one_to_one.size());
  found.upper_bound = std::min(num_used, found.upper_bound + others);
  found.evidence_upper_bound += static_cast<double>(others);
}

/// The poses between the caller's frames that the priors admit.
std::vector<Similarity> admitted_poses(const std::vector<Similarity>& centred_poses,
                                       const Correspondences& centred, const Priors& priors) {
  std::vector<Similarity> poses;
  for (const Similarity& pose : centred_poses) {
    const auto admitted = admitted_pose(uncentre(pose, centred), priors);
    if (admitted) poses.push_back(*admitted);
  }
  return poses;
}

ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(default_scale_range(correspondences));
}

std::string no_pose_reason(const Diagnostics& diagnostics, const Options& options) {
  if (!diagnostics.limits_hit.empty()) return "no pose was found before a limit ended the search";
  return options.admit_all() ? "no three correspondences agree on a pose"
                                : "no three correspondences agree on a pose that the priors admit, "
                                  "as far as was found";
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
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.num_correspondences = diagnostics.num_used = source.cols();
  diagnostics.num_threads = resolve_num_threads(options.num_threads);
  const auto give_up = [&](Status status, const std::string& reason, Index upper_bound) {
    result.status = status;
    result.status_reason = reason;
    result.certificate = certify(0, upper_bound, 0, static_cast<double>(upper_bound));
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
    return Objective(centred, options.evidence, options.memory_limit / 4, scales,
                     octaves_of(options, input));
  }();
  if (!objective.weights_complete()) {
    context.limit("the memory budget does not suffice for distinct evidence: inliers were counted");
  }
  const PoseConstraints constraints{scales, options, centred.source_origin,
                                    centred.target_origin};
  const PairFilter filter(centred, options, options.one_to_one, scales);
  MethodResult found = options.method == Method::Gmcr
                           ? solve_gmcr(context, objective, constraints, filter)
                           : solve_paper(context, centred, constraints, filter);
  bound_all_inliers(found, diagnostics.num_used, filter);
  if (options.least_squares) {
    for (Similarity& pose : found.poses) pose = fit_to_consensus(objective, constraints, pose);
  }
  found.poses = admitted_poses(found.poses, centred, options);
  if (found.poses.empty()) {
    return give_up(Status::NoConsensus, no_pose_reason(diagnostics, options), found.upper_bound);
  }
  conclude(result, context, found, input, objective);
  diagnostics.total_seconds = clock.elapsed();
  return result;
}

}  // namespace gmcr
