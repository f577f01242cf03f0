#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "frontend/cloud_notes.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/features/stage_clock.hpp"
#include "frontend/judgement/hypotheses.hpp"
#include "frontend/judgement/judged_pose.hpp"
#include "frontend/judgement/verdict.hpp"
#include "frontend/refine_clouds.hpp"
#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr {
namespace {

/// Source voxels above which an attempt that keeps all matches costs more than it is worth.
constexpr Index kMostUnfiltered = 3000;

/// Registers the matches, with the bound that they come with or one from the matches themselves,
/// which then is theirs.
Result register_matches(CloudMatches& matches, const Options& options) {
  if (options.noise_mode == NoiseMode::Given) {
    return register_correspondences(matches.source, matches.target,
                                    frontend::options_with_bound(options, matches));
  }
  Result result = register_correspondences(matches.source, matches.target, options);
  if (result.noise_estimate) matches.noise_bound = result.noise_estimate->noise_bound;
  return result;
}

/// Poses of the matches of an attempt that the surfaces choose from.
constexpr int kHypotheses = 4;

/// The options with so many hypotheses, where the method has several.
Options with_hypotheses(Options options) {
  if (options.method == Method::Gmcr) {
    options.num_hypotheses = std::max(options.num_hypotheses, kHypotheses);
  }
  return options;
}

/// A result that may be returned.
struct Attempt {
  CloudResult result;
  Similarity matched;             ///< the pose that the matches gave
  frontend::Candidate candidate;  ///< its pose; its overlap is what attempts are compared by
  std::shared_ptr<frontend::CentredPair> voxels;  ///< of the matches; null: none
};

/// One attempt from raw clouds to a pose of the matches.
/// @return nullopt where the graph of the matches exceeds the memory budget and this is not the
///   `first` attempt, which would throw.
std::optional<CloudResult> attempt(frontend::CloudScales& source, frontend::CloudScales& target,
                                   const FrontendOptions& frontend, const Options& options,
                                   const frontend::FrontendSetting& setting, bool first) {
  CloudResult result;
  result.num_source_points = source.points().cols();
  result.num_target_points = target.points().cols();
  frontend::begin_stage(options, "matching");
  result.matches = frontend::match_with(source, target, frontend, options, setting);
  const Index num_matches = result.matches.source.cols();
  if (!first && BitsetGraph::bytes_required(num_matches) > options.memory_limit) {
    return std::nullopt;
  }
  result.registration = register_matches(result.matches, options);
  return result;
}

/// Judges the pose of the matches as it is.
Attempt judged(CloudResult result, const Options& options) {
  const Similarity pose = result.registration.target_from_source;
  const Status status = result.registration.status;
  auto voxels = frontend::voxel_pair(result.matches);
  if (status == Status::Ok || status == Status::Degenerate) {
    frontend::judge_pose(result, *voxels, options);
  } else {
    frontend::judge(result);
  }
  const double overlap = result.fitness + result.target_fitness;
  return {std::move(result), pose, {pose, false, 0, overlap}, std::move(voxels)};
}

/// Judges the pose of the matches, or the alternative at which the surfaces meet best.
/// @param hypotheses  of all attempts, made by the first that has a pose.
Attempt refined(CloudResult result, std::optional<frontend::Hypotheses>& hypotheses,
                const Options& options, const parallel::Deadline& deadline) {
  if (result.registration.status != Status::Ok) return judged(std::move(result), options);
  frontend::StageClock clock(result.registration.diagnostics.stages);
  frontend::begin_stage(options, "comparison");
  auto voxels = frontend::voxel_pair(result.matches);
  if (!hypotheses) {
    hypotheses.emplace(voxels, result.matches.target_voxel_size, options, deadline);
  }
  const Similarity matched = result.registration.target_from_source;
  const frontend::Candidate candidate = hypotheses->best_of(result.registration);
  result = frontend::take(std::move(result), candidate, *voxels, options);
  clock.lap("comparison");
  return {std::move(result), matched, candidate, std::move(voxels)};
}

/// The pose of `next` with the matches that speak for it more clearly, its own or those of `best`.
Attempt with_clearer_matches(Attempt next, const Attempt& best, const Options& options) {
  if (!best.voxels || best.result.registration.status != Status::Ok) return next;
  CloudResult other = frontend::take(best.result, next.candidate, *best.voxels, options);
  const auto key = [](const CloudResult& result) {
    return std::tuple(-static_cast<int>(result.verdict), result.distinct_evidence);
  };
  if (key(other) > key(next.result)) {
    next.result = std::move(other);
    next.voxels = best.voxels;
  }
  return next;
}

/// The pose that is clearly better by the surfaces, or better by both them and the matches, where
/// these were filtered and their agreement says something.
frontend::Candidate preferred(const Attempt& attempt, frontend::Hypotheses& hypotheses,
                              const Options& options) {
  const frontend::Candidate best = hypotheses.challenged(attempt.candidate);
  if (!attempt.result.matches.filtered) return best;
  for (const frontend::Candidate& other : hypotheses.better_than(best)) {
    const double evidence = frontend::evidence_of(attempt.result, other, options);
    if (evidence > frontend::evidence_of(attempt.result, best, options)) return other;
  }
  return best;
}

/// Looks at the rivals of a pose, and takes one that is preferred to it.
void compare_with_rivals(Attempt& attempt, frontend::Hypotheses& hypotheses,
                         const Options& options) {
  frontend::StageClock clock(attempt.result.registration.diagnostics.stages);
  const Similarity before = attempt.candidate.target_from_source;
  attempt.candidate = preferred(attempt, hypotheses, options);
  attempt.result.rivals = hypotheses.rivals_of(attempt.candidate);
  if (attempt.candidate.target_from_source.matrix() == before.matrix()) {
    frontend::judge(attempt.result);
  } else {
    attempt.result =
        frontend::take(std::move(attempt.result), attempt.candidate, *attempt.voxels, options);
  }
  clock.lap("comparison");
}

/// Keeps the alternatives that the caller asked for.
void keep_alternatives(Result& registration, const Options& options) {
  const auto asked = static_cast<std::size_t>(options.num_hypotheses - 1);
  auto& alternatives = registration.alternatives;
  alternatives.resize(std::min(alternatives.size(), asked));
}

/// How the surfaces meet tells more than the numbers of matches of unlike attempts.
bool better(const Attempt& a, const Attempt& b) {
  const auto worth = [](const Attempt& attempt) {
    switch (attempt.result.verdict) {
      case Verdict::Trusted:
        return 1.2 * attempt.candidate.overlap;
      case Verdict::Doubtful:
        return 1.1 * attempt.candidate.overlap;
      default:
        return attempt.candidate.overlap;
    }
  };
  return worth(a) > worth(b);
}

void add_stages(std::vector<StageTime>& sum, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) frontend::add_stage(sum, stage.name, stage.seconds);
}

/// Whether the mirrored source fits the target, by the first setting.
bool fits_mirrored(const PointsRef& source, frontend::CloudScales& target,
                   const FrontendOptions& frontend, const Options& options,
                   const parallel::Deadline& deadline) {
  if (deadline.expired() || !options.admit_all()) return false;
  Points mirrored = source;
  mirrored.row(0) *= -1;
  FrontendOptions seen = frontend;
  seen.source_viewpoint.x() *= -1;
  Options remaining = with_hypotheses(options);
  remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
  const PointsRef mirrored_points = mirrored;
  frontend::CloudScales from(mirrored_points);
  auto tried =
      attempt(from, target, seen, remaining,
              frontend::list_settings(seen, {mirrored_points, target.points()}).front(), false);
  if (!tried) return false;
  std::optional<frontend::Hypotheses> hypotheses;
  Attempt best = refined(std::move(*tried), hypotheses, options, deadline);
  if (best.result.registration.status != Status::Ok) return false;
  compare_with_rivals(best, *hypotheses, options);
  return best.result.verdict == Verdict::Trusted;
}

}  // namespace

CloudResult frontend::register_scales(CloudScales& source, CloudScales& target,
                                      const FrontendOptions& frontend, const Options& asked) {
  bool is_stopped = false;  // a caller who wants to stop says so to one stage, and means all
  Options options = asked;
  if (asked.progress) {
    options.progress = [&](const Progress& progress) {
      is_stopped = is_stopped || !asked.progress(progress);
      return !is_stopped;
    };
  }
  const parallel::Stopwatch stopwatch;
  const parallel::Deadline deadline(options.time_limit, options.stop);
  const bool refines = frontend.refine == Refine::Icp;
  Attempt best;
  std::optional<frontend::Hypotheses> hypotheses;
  std::vector<StageTime> stages;
  std::vector<LimitHit> limits;
  int num_attempts = 0;
  for (const frontend::FrontendSetting& setting :
       list_settings(frontend, {source.points(), target.points()})) {
    const bool too_many =
        num_attempts > 0 && best.result.matches.source_voxels.cols() > kMostUnfiltered;
    if (setting.keep_all_matches && too_many) continue;
    // an attempt that cannot come to its pose would only take time
    const bool is_late = deadline.remaining() < deadline.elapsed() / std::max(1, num_attempts);
    if (num_attempts > 0 && is_late) {
      limits.push_back({Limit::Time, "the time budget ended the attempts at other settings"});
      break;
    }
    Options remaining = refines ? with_hypotheses(options) : options;
    remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
    auto tried = attempt(source, target, frontend, remaining, setting, num_attempts == 0);
    if (!tried) {
      limits.push_back({Limit::Memory, "the memory budget kept out an attempt with more matches"});
      continue;
    }
    Attempt next = refines ? refined(std::move(*tried), hypotheses, options, deadline)
                           : judged(std::move(*tried), options);
    add_stages(stages, next.result.matches.stages);
    add_stages(stages, next.result.registration.diagnostics.stages);
    if (next.result.matches.share_compared < 1) {
      const long percent = std::lround(100 * next.result.matches.share_compared);
      limits.push_back({Limit::Time, "the time budget ended the matching after " +
                                         std::to_string(percent) + " % of the source"});
    }
    ++num_attempts;
    if (num_attempts == 1) {
      best = std::move(next);
    } else if (better(next, best)) {
      best = refines ? with_clearer_matches(std::move(next), best, options) : std::move(next);
    }
    if (best.result.verdict == Verdict::Trusted) break;
  }
  CloudResult& result = best.result;
  result.num_attempts = num_attempts;
  result.registration.diagnostics.stages = std::move(stages);
  if (refines) {
    result.refinement.method = "icp";
    result.refinement.note = "no pose to refine";
    if (result.registration.status == Status::Ok) {
      compare_with_rivals(best, *hypotheses, options);
      result = frontend::settle(std::move(result), source.points(), target.points(), *best.voxels,
                                best.matched, options, deadline);
    }
    keep_alternatives(result.registration, options);
    if (result.verdict != Verdict::Trusted &&
        fits_mirrored(source.points(), target, frontend, options, deadline)) {
      result.notes.push_back(
          "the mirrored source fits the target: one of the clouds is left-handed, negate one of "
          "its coordinates");
    }
  }
  auto& limits_hit = result.registration.diagnostics.limits_hit;
  limits_hit.insert(limits_hit.end(), limits.begin(), limits.end());
  result.registration.diagnostics.total_seconds = stopwatch.elapsed();
  return std::move(result);
}

void frontend::refuse_noise_bounds(const Options& options) {
  if (options.noise_bounds.empty()) return;
  throw InvalidOption("noise_bounds", std::to_string(options.noise_bounds.size()) +
                                          " values for matches that are not known yet");
}

CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend, const Options& options) {
  frontend::validate_pair(source, target, frontend, options);
  frontend::refuse_noise_bounds(options);
  const frontend::DistinctCloud from = frontend::without_repeats(source);
  const frontend::DistinctCloud to = frontend::without_repeats(target);
  const PointsRef source_kept = from.kept ? PointsRef(*from.kept) : source;
  const PointsRef target_kept = to.kept ? PointsRef(*to.kept) : target;
  frontend::CloudScales source_scales(source_kept), target_scales(target_kept);
  CloudResult result = frontend::register_scales(source_scales, target_scales, frontend, options);
  result.num_source_points = source.cols();
  result.num_target_points = target.cols();
  frontend::add_notes(result, source, target, from, to, frontend, options);
  return result;
}

}  // namespace gmcr
