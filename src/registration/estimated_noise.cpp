#include "registration/estimated_noise.hpp"

#include <algorithm>
#include <string>

#include "noise/noise_estimation.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"
#include "problem/objective/objective.hpp"
#include "proof/certificate.hpp"
#include "registration/judgement/verdict.hpp"

namespace gmcr::registration {
namespace {

Options with_bound(const Options& options, double noise_bound) {
  Options given = options;
  given.noise_mode = NoiseMode::Given;
  given.noise_bound = noise_bound;
  return given;
}

/// The options of the solve after the choice: what is left of the time; and where the caller
/// stopped the choice, the solve is stopped as well.
Options remaining_options(const Options& options, const noise::ChosenNoise& chosen,
                          const parallel::Deadline& deadline) {
  Options remaining = with_bound(options, chosen.estimate->noise_bound);
  remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
  if (chosen.cancelled) remaining.progress = [](const Progress&) { return false; };
  return remaining;
}

/// The answer where no consensus stands out.
Result no_pose(Status status, const PointsRef& source, const PointsRef& target,
               const Options& options, const std::string& reason) {
  const Index count = source.cols();
  Result result;
  result.status = status;
  result.status_reason = reason;
  judge_without_pose(result, source, target, options);
  result.certificate = proof::certify(0, count, 0, static_cast<double>(count));
  result.diagnostics.num_correspondences = count;
  result.diagnostics.num_used = count;
  result.diagnostics.num_threads = parallel::resolve_num_threads(options.num_threads);
  return result;
}

std::string no_consensus_reason(const noise::ChosenNoise& chosen) {
  return chosen.late || chosen.cancelled
             ? "no noise bound was found before a limit ended the search"
             : "no noise bound makes the consensus better than chance";
}

}  // namespace

Result with_noise_bound(const PointsRef& source, const PointsRef& target, const Options& options,
                        const Solve& solve) {
  if (options.noise_mode == NoiseMode::Given) return solve(source, target, options);
  if (source.cols() < problem::kMinInliers) {
    return no_pose(Status::TooFewCorrespondences, source, target, options,
                   std::to_string(source.cols()) + " correspondences; " +
                       std::to_string(problem::kMinInliers) + " are needed");
  }
  const parallel::Deadline deadline(options.time_limit, options.stop);
  const noise::ChosenNoise chosen = noise::choose_noise(source, target, options);
  const bool stands_out = chosen.estimate && chosen.estimate->log10_false_alarms < 0;
  Result result = stands_out ? solve(source, target, remaining_options(options, chosen, deadline))
                             : no_pose(Status::NoConsensus, source, target, options,
                                       no_consensus_reason(chosen));
  if (!chosen.estimate) return result;
  result.noise_estimate = chosen.estimate;
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.stages.insert(diagnostics.stages.begin(), {"noise_bound", chosen.seconds});
  diagnostics.total_seconds += chosen.seconds;
  diagnostics.num_clique_nodes += chosen.num_clique_nodes;
  if (chosen.late) {
    diagnostics.limits_hit.push_back(
        {Limit::Time, "the time budget ended the search for a noise bound"});
  }
  if (chosen.cancelled) {
    diagnostics.limits_hit.push_back(
        {Limit::Stopped, "the caller stopped the search for a noise bound"});
  }
  return result;
}

}  // namespace gmcr::registration
