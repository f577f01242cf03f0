#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "frontend/cloud_pair.hpp"
#include "frontend/overlap.hpp"
#include "frontend/refine_clouds.hpp"
#include "frontend/stage_clock.hpp"
#include "frontend/verdict.hpp"
#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr {
namespace {

/// Source voxels above which an attempt that keeps all matches costs more than it is worth.
constexpr Index kMostUnfiltered = 3000;

/// Options to solve with, or to judge a pose with: by then the bound is known.
Options options_with_bound(const Options& options, const CloudMatches& matches) {
  Options given = options;
  given.noise_mode = NoiseMode::Given;
  given.noise_bound = matches.noise_bound;
  return given;
}

/// Registers the matches, with the bound that they come with or one from the matches themselves,
/// which then is theirs.
Result register_matches(CloudMatches& matches, const Options& options) {
  if (options.noise_mode == NoiseMode::Given) {
    return register_correspondences(matches.source, matches.target,
                                    options_with_bound(options, matches));
  }
  Result result = register_correspondences(matches.source, matches.target, options);
  if (result.noise_estimate) matches.noise_bound = result.noise_estimate->noise_bound;
  return result;
}

/// How the voxels of the two clouds meet under the pose, both ways, and what the inliers are worth.
void measure_fit(CloudResult& result, const Options& options) {
  const CloudMatches& matches = result.matches;
  const Similarity& pose = result.registration.target_from_source;
  const double radius = matches.target_voxel_size;
  const frontend::Overlap forward = frontend::measure_overlap(
      matches.source_voxels, matches.target_voxels, pose, radius, options.num_threads);
  const frontend::Overlap backward =
      frontend::measure_overlap(matches.target_voxels, matches.source_voxels, pose.inverse(),
                                radius / pose.scale, options.num_threads);
  result.fitness = forward.fitness;
  result.overlap_rmse = forward.rmse;
  result.target_fitness = backward.fitness;
  Options distinct = options_with_bound(options, matches);
  distinct.evidence = Evidence::Distinct;
  result.distinct_evidence =
      evaluate_consensus(pose, matches.source, matches.target, distinct).evidence;
}

/// A judged pose, and the one that the matches gave.
struct Attempt {
  CloudResult result;
  Similarity matched;
};

/// One attempt from raw clouds to a judged pose, refined on its voxels where that is asked for.
/// @return nullopt where the graph of the matches exceeds the memory budget and this is not the
///   `first` attempt, which would throw.
std::optional<Attempt> attempt(const PointsRef& source, const PointsRef& target,
                               const FrontendOptions& frontend, const Options& options,
                               const frontend::FrontendSetting& setting, bool first) {
  const parallel::Deadline deadline(options.time_limit, options.stop);
  CloudResult result;
  result.num_source_points = source.cols();
  result.num_target_points = target.cols();
  result.matches = frontend::match_with(source, target, frontend, options, setting);
  const Index num_matches = result.matches.source.cols();
  if (!first && BitsetGraph::bytes_required(num_matches) > options.memory_limit) {
    return std::nullopt;
  }
  result.registration = register_matches(result.matches, options);
  const Status status = result.registration.status;
  if (status == Status::Ok || status == Status::Degenerate) measure_fit(result, options);
  frontend::judge(result);
  const Similarity matched = result.registration.target_from_source;
  if (frontend.refine == Refine::Icp) {
    result = frontend::approach(std::move(result), options, deadline);
  }
  return Attempt{std::move(result), matched};
}

/// Below trust, how the surfaces meet tells more than the numbers of matches of unlike attempts.
bool better(const CloudResult& a, const CloudResult& b) {
  const auto key = [](const CloudResult& r) {
    return std::tuple(r.verdict == Verdict::Trusted, r.fitness + r.target_fitness);
  };
  return key(a) > key(b);
}

void add_stages(std::vector<StageTime>& sum, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) frontend::add_stage(sum, stage.name, stage.seconds);
}

}  // namespace

CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend, const Options& options) {
  frontend::validate_pair(source, target, frontend, options);
  if (!options.noise_bounds.empty()) {
    throw InvalidOption("noise_bounds", std::to_string(options.noise_bounds.size()) +
                                            " values for matches that are not known yet");
  }
  const parallel::Stopwatch stopwatch;
  const parallel::Deadline deadline(options.time_limit, options.stop);
  CloudResult best;
  Similarity matched;
  std::vector<StageTime> stages;
  std::vector<LimitHit> limits;
  int num_attempts = 0;
  for (const frontend::FrontendSetting& setting : frontend::list_settings(frontend)) {
    const bool too_many = num_attempts > 0 && best.matches.source_voxels.cols() > kMostUnfiltered;
    if (setting.keep_all_matches && too_many) continue;
    if (num_attempts > 0 && deadline.expired()) {
      limits.push_back({Limit::Time, "the time budget ended the attempts at other settings"});
      break;
    }
    Options remaining = options;
    remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
    auto tried = attempt(source, target, frontend, remaining, setting, num_attempts == 0);
    if (!tried) {
      limits.push_back({Limit::Memory, "the memory budget kept out an attempt with more matches"});
      continue;
    }
    add_stages(stages, tried->result.matches.stages);
    add_stages(stages, tried->result.registration.diagnostics.stages);
    ++num_attempts;
    if (num_attempts == 1 || better(tried->result, best)) {
      best = std::move(tried->result);
      matched = tried->matched;
    }
    if (best.verdict == Verdict::Trusted) break;
  }
  best.num_attempts = num_attempts;
  best.registration.diagnostics.stages = std::move(stages);
  if (frontend.refine == Refine::Icp) {
    best = frontend::settle(std::move(best), source, target, matched, options, deadline);
  }
  auto& limits_hit = best.registration.diagnostics.limits_hit;
  limits_hit.insert(limits_hit.end(), limits.begin(), limits.end());
  best.registration.diagnostics.total_seconds = stopwatch.elapsed();
  return best;
}

CloudResult with_pose(CloudResult result, const Similarity& target_from_source,
                      const Options& options) {
  Result& registration = result.registration;
  const Options solver = options_with_bound(options, result.matches);
  Consensus consensus =
      evaluate_consensus(target_from_source, result.matches.source, result.matches.target, solver);
  Uncertainty uncertainty = evaluate_uncertainty(target_from_source, result.matches.source,
                                                 result.matches.target, consensus.inliers, solver);
  registration.target_from_source = target_from_source;
  registration.inliers = std::move(consensus.inliers);
  registration.evidence = consensus.evidence;
  registration.consistent_scales = uncertainty.consistent_scales;
  registration.covariance = std::move(uncertainty.covariance);
  measure_fit(result, options);
  frontend::judge(result);
  return result;
}

}  // namespace gmcr
