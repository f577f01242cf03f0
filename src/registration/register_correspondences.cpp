#include <algorithm>
#include <numeric>
#include <string>

#include "estimation/admitted.hpp"
#include "estimation/pose_constraints.hpp"
#include "gmcr/registration.hpp"
#include "noise/noise_estimation.hpp"
#include "paper/paper_method.hpp"
#include "parallel/parallel_for.hpp"
#include "problem/correspondences.hpp"
#include "problem/input.hpp"
#include "problem/objective.hpp"
#include "problem/pair_filter.hpp"
#include "problem/run.hpp"
#include "proof/certificate.hpp"
#include "refine/least_squares.hpp"
#include "registration/answer.hpp"
#include "search/best_poses.hpp"
#include "search/scale_modes.hpp"

namespace gmcr {
namespace {

std::vector<Index> indices_below(Index count) {
  std::vector<Index> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

/// The correspondences that the priors on the translation admit, ascending.
std::vector<Index> admitted_correspondences(const problem::Correspondences& centred,
                                            const Options& options, const ScaleRange& scales) {
  std::vector<Index> admitted = indices_below(centred.size());
  const problem::PairFilter filter(centred, options, false, scales);
  std::erase_if(admitted, [&](Index i) { return !filter.admits(i, scales); });
  return admitted;
}

/// Bounds on all inliers of a pose from those on sets of which no two share a point.
///
/// Let nu(S) be the size of a largest one-to-one subset of S. Adding a correspondence to S raises
/// nu by at most 1, so |S| - nu(S) never falls as S grows: |S| <= nu(S) + |all| - nu(all), and any
/// one-to-one subset of all has at most nu(all). Each of the others gives evidence of at most 1.
void bound_all_inliers(search::MethodResult& found, Index num_used,
                       const problem::PairFilter& filter) {
  const std::vector<Index> one_to_one = filter.one_to_one(indices_below(num_used));
  const Index others = num_used - static_cast<Index>(one_to_one.size());
  found.upper_bound = std::min(num_used, found.upper_bound + others);
  found.evidence_upper_bound += static_cast<double>(others);
}

/// The poses between the caller's frames that the priors admit.
std::vector<Similarity> admitted_poses(const std::vector<Similarity>& centred_poses,
                                       const problem::Correspondences& centred,
                                       const Priors& priors) {
  std::vector<Similarity> poses;
  for (const Similarity& pose : centred_poses) {
    const auto admitted = estimation::admitted_pose(problem::uncentre(pose, centred), priors);
    if (admitted) poses.push_back(*admitted);
  }
  return poses;
}

ScaleRange scales_to_search(const Options& options,
                            const problem::Correspondences& correspondences) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(search::default_scale_range(correspondences));
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
  problem::validate_input(source, target, options);
  if (options.noise_mode == NoiseMode::Estimated) {
    return noise::register_with_estimated_noise(source, target, options);
  }
  Result result;
  problem::SolveContext context(options, result.diagnostics);
  const parallel::Deadline clock(0);
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.num_correspondences = diagnostics.num_used = source.cols();
  diagnostics.num_threads = parallel::resolve_num_threads(options.num_threads);
  const auto give_up = [&](Status status, const std::string& reason, Index upper_bound) {
    result.status = status;
    result.status_reason = reason;
    result.certificate = proof::certify(0, upper_bound, 0, static_cast<double>(upper_bound));
    diagnostics.total_seconds = clock.elapsed();
    return result;
  };
  if (source.cols() < problem::kMinInliers) {
    return give_up(Status::TooFewCorrespondences,
                   std::to_string(source.cols()) + " correspondences; 3 are needed", source.cols());
  }

  const problem::Correspondences input = problem::correspondences_of(source, target, options);
  problem::Correspondences centred = problem::centre(input.source, input.target, input.bounds);
  const ScaleRange scales = scales_to_search(options, centred);
  diagnostics.scale_range = scales;
  const std::vector<Index> used = admitted_correspondences(centred, options, scales);
  diagnostics.num_used = static_cast<Index>(used.size());
  if (diagnostics.num_used < problem::kMinInliers) {
    return give_up(Status::NoConsensus,
                   "the priors on the translation admit " + std::to_string(used.size()) +
                       " correspondences; 3 are needed",
                   diagnostics.num_used);
  }
  context.require_memory_for_graph(diagnostics.num_used);
  if (diagnostics.num_used < input.size()) {
    const problem::Correspondences kept = problem::subset(input, used);
    centred = problem::centre(kept.source, kept.target, kept.bounds);
  }

  const problem::Objective objective = [&] {
    const problem::StageTimer timer(context, "evidence");
    return problem::Objective(centred, options.evidence, options.memory_limit / 4, scales,
                              search::octaves_of(options, input));
  }();
  if (!objective.weights_complete()) {
    context.limit(
        {Limit::Memory,
         "the memory budget does not suffice for distinct evidence: inliers were counted"});
  }
  const estimation::PoseConstraints constraints{scales, options, centred.source_origin,
                                                centred.target_origin};
  const problem::PairFilter filter(centred, options, options.one_to_one, scales);
  search::MethodResult found = options.method == Method::Gmcr
                                   ? search::solve_gmcr(context, objective, constraints, filter)
                                   : paper::solve_paper(context, centred, constraints, filter);
  bound_all_inliers(found, diagnostics.num_used, filter);
  if (options.least_squares) {
    for (Similarity& pose : found.poses)
      pose = refine::fit_to_consensus(objective, constraints, pose);
  }
  found.poses = admitted_poses(found.poses, centred, options);
  if (found.poses.empty()) {
    return give_up(Status::NoConsensus, no_pose_reason(diagnostics, options), found.upper_bound);
  }
  registration::conclude(result, context, found, input, objective);
  diagnostics.total_seconds = clock.elapsed();
  return result;
}

}  // namespace gmcr
