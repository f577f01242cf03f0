#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "frontend/cloud_pair.hpp"
#include "frontend/overlap.hpp"
#include "frontend/stage_clock.hpp"
#include "frontend/verdict.hpp"
#include "gmcr/registration.hpp"

namespace gmcr {
namespace {

/// Source voxels above which an attempt that keeps all matches costs more than it is worth.
constexpr Index kMostUnfiltered = 3000;

/// A solver needs some time to say that it has none.
constexpr double kLeastSeconds = 1e-3;

/// How the voxels of the two clouds meet under the pose, both ways.
void measure_fit(CloudResult& result, int num_threads) {
  const CloudMatches& matches = result.matches;
  const Similarity& pose = result.registration.target_from_source;
  const double radius = matches.target_voxel_size;
  const Overlap forward =
      measure_overlap(matches.source_voxels, matches.target_voxels, pose, radius, num_threads);
  const Overlap backward = measure_overlap(matches.target_voxels, matches.source_voxels,
                                           pose.inverse(), radius / pose.scale, num_threads);
  result.fitness = forward.fitness;
  result.overlap_rmse = forward.rmse;
  result.target_fitness = backward.fitness;
}

Options solver_options(const Options& options, const CloudMatches& matches) {
  Options solver = options;
  solver.noise_bound = matches.noise_bound;
  return solver;
}

/// One attempt from raw clouds to a judged pose.
CloudResult attempt(const PointsRef& source, const PointsRef& target,
                    const FrontendOptions& frontend, const Options& options,
                    const FrontendSetting& setting) {
  CloudResult result;
  result.num_source_points = source.cols();
  result.num_target_points = target.cols();
  result.matches = match_with(source, target, frontend, options, setting);
  result.registration = register_correspondences(result.matches.source, result.matches.target,
                                                 solver_options(options, result.matches));
  if (result.registration.status == Status::Ok) measure_fit(result, options.num_threads);
  judge(result);
  return result;
}

/// Below trust, how the surfaces meet tells more than the numbers of matches of unlike attempts.
bool better(const CloudResult& a, const CloudResult& b) {
  const auto key = [](const CloudResult& r) {
    return std::tuple(r.verdict == Verdict::Trusted, r.fitness + r.target_fitness);
  };
  return key(a) > key(b);
}

void add_stages(std::vector<StageTime>& sum, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) add_stage(sum, stage.name, stage.seconds);
}

}  // namespace

CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend, const Options& options) {
  validate_pair(source, target, frontend, options);
  if (!options.noise_bounds.empty()) {
    throw std::invalid_argument("noise_bounds: " + std::to_string(options.noise_bounds.size()) +
                                " values for matches that are not known yet");
  }
  const Deadline deadline(options.budget.time);
  CloudResult best;
  std::vector<StageTime> stages;
  int num_attempts = 0;
  for (const FrontendSetting& setting : list_settings(frontend)) {
    const bool too_many = num_attempts > 0 && best.matches.source_voxels.cols() > kMostUnfiltered;
    if (setting.keep_all_matches && too_many) continue;
    if (num_attempts > 0 && deadline.expired()) {
      best.registration.diagnostics.limits_hit.push_back(
          "the time budget ended the attempts at other settings");
      break;
    }
    Options remaining = options;
    remaining.budget.time = std::max(deadline.remaining(), kLeastSeconds);
    CloudResult result = attempt(source, target, frontend, remaining, setting);
    add_stages(stages, result.matches.stages);
    add_stages(stages, result.registration.diagnostics.stages);
    ++num_attempts;
    if (num_attempts == 1 || better(result, best)) best = std::move(result);
    if (best.verdict == Verdict::Trusted) break;
  }
  best.num_attempts = num_attempts;
  best.registration.diagnostics.stages = std::move(stages);
  best.registration.diagnostics.total_seconds = deadline.elapsed();
  return best;
}

CloudResult with_pose(CloudResult result, const Similarity& target_from_source,
                      const Options& options) {
  Result& registration = result.registration;
  Consensus consensus =
      evaluate_consensus(target_from_source, result.matches.source, result.matches.target,
                         solver_options(options, result.matches));
  registration.target_from_source = target_from_source;
  registration.inliers = std::move(consensus.inliers);
  registration.evidence = consensus.evidence;
  Certificate& certificate = registration.certificate;
  certificate.lower = static_cast<Index>(registration.inliers.size());
  certificate.upper = std::max(certificate.upper, certificate.lower);
  certificate.certified = certificate.lower == certificate.upper;
  measure_fit(result, options.num_threads);
  judge(result);
  return result;
}

}  // namespace gmcr
