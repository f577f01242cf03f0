#include "frontend/attempts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "frontend/features/stage_clock.hpp"
#include "frontend/judgement/judged_pose.hpp"
#include "frontend/judgement/verdict.hpp"
#include "frontend/judgement/view_search.hpp"
#include "frontend/refine_clouds.hpp"
#include "frontend/unknown_scale.hpp"
#include "gmcr/registration.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

/// Poses of the matches of an attempt that the surfaces choose from.
constexpr int kHypotheses = 4;

bool exceeds_memory(const CloudMatches& matches, const Options& options) {
  return BitsetGraph::bytes_required(matches.source.cols()) > options.memory_limit;
}

/// Overlap over that of a pose that matches speak for, above which one that they do not is better.
constexpr double kMuchBetter = 1.25;
/// Overlap of the mirrored source over that of the source above which it fits better.
constexpr double kFitsBetter = 1.03;
constexpr double kWorthAGlance = 0.8;  // the same by a peek
/// Share of its evidence with which matches speak for another pose as well.
constexpr double kSpeaksToo = 0.5;

/// How the surfaces meet tells more than the numbers of matches of unlike attempts.
bool better(const Attempt& a, const Attempt& b) {
  const auto worth = [](const Attempt& attempt) {
    switch (attempt.result.verdict) {
      case Verdict::Trusted:
        return 1.35 * attempt.candidate.overlap;
      case Verdict::Doubtful:
        return (attempt.result.found_by_turning ? 1.1 : kMuchBetter) * attempt.candidate.overlap;
      default:
        return attempt.candidate.overlap;
    }
  };
  return worth(a) > worth(b);
}

void add_stages(std::vector<StageTime>& sum, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) add_stage(sum, stage.name, stage.seconds);
}

}  // namespace

Attempts::Attempts(CloudScales& source, CloudScales& target, const FrontendOptions& frontend,
                   const Options& options, const parallel::Deadline& deadline)
    : source_(source),
      target_(target),
      frontend_(frontend),
      options_(options),
      deadline_(deadline) {}

std::optional<CloudResult> Attempts::match(const FrontendSetting& setting) {
  CloudResult result;
  result.num_source_points = source_.points().cols();
  result.num_target_points = target_.points().cols();
  begin_stage(options_, "matching");
  const std::optional<double> scale = guessed_scale(setting);
  Options options = in_time(options_);
  FrontendOptions frontend = frontend_;
  if (scale) {
    options.scale_range = scales_about(*scale, options_);
    frontend = at_scale(frontend_, *scale, source_, target_);
  }
  result.matches = match_with(source_, target_, frontend, options, setting);
  if (count_ > 0 && exceeds_memory(result.matches, options_)) return std::nullopt;
  if (count_ == 0) judge_by_voxels_of(result.matches);
  result.voxels = voxels_;
  const bool compares = refines() && options_.method == Method::Gmcr;
  if (compares && !scale) {
    options.num_hypotheses = std::max(options_.num_hypotheses, kHypotheses);
  }
  result.registration = register_matches(result.matches, options);
  if (scale && compares) add_poses_at_scale(result, in_time(options_), kHypotheses);
  return result;
}

Options Attempts::in_time(Options options) const {
  options.time_limit = std::max(deadline_.remaining(), parallel::kLeastSeconds);
  return options;
}

/// Where the scale is narrowed down, that at which most matches of the clouds agree, each at voxels
/// by its own extent.
std::optional<double> Attempts::guessed_scale(const FrontendSetting& setting) {
  if (!narrows_scale(options_)) return std::nullopt;
  Options options = in_time(options_);
  CloudResult guess;
  guess.matches = match_with(source_, target_, frontend_, options, setting);
  if (exceeds_memory(guess.matches, options_)) return std::nullopt;
  // a number of inliers closes most scales at once, evidence few; where few agree, the first
  // attempt goes by evidence, further ones by the number
  options.evidence = Evidence::Count;
  guess.registration = register_matches(guess.matches, options);
  if (count_ == 0 && guess.registration.inliers.size() < kSureOfScale) {
    add_stages(stages_, guess.registration.diagnostics.stages);
    options.evidence = options_.evidence;
    guess.registration = register_matches(guess.matches, options);
  }
  note_limits(guess);
  if (guess.registration.status != Status::Ok) return std::nullopt;
  return guess.registration.target_from_source.scale;
}

void Attempts::judge_by_voxels_of(const CloudMatches& matches) {
  voxels_ = {matches.source_voxels,
             matches.target_voxels,
             matches.source_voxel_size,
             matches.target_voxel_size,
             {},
             {}};
  pair_ = centred_pair(voxels_, options_.num_threads);
  if (pair_ && refines()) see(*pair_);
  hypotheses_.reset();
}

std::vector<RivalPose> Attempts::rivals_of(const CloudResult& result, const Candidate& candidate) {
  return hypotheses_->rivals_of(
      candidate, [&](const Candidate& other) { return evidence_of(result, other, options_); });
}

/// Gives a pair what the sensors saw, where they were somewhere known.
void Attempts::see(CentredPair& pair) {
  if (!views_) {
    views_.emplace();
    if (frontend_.orientation != NormalOrientation::Outward) {
      parallel::call_both(
          options_.num_threads,
          [&] { views_->first = view_from(frontend_.source_viewpoint, source_.points()); },
          [&] { views_->second = view_from(frontend_.target_viewpoint, target_.points()); });
    }
  }
  std::tie(pair.source_view, pair.target_view) = *views_;
  if (pair.source_view) voxels_.source_viewpoint = frontend_.source_viewpoint;
  if (pair.target_view) voxels_.target_viewpoint = frontend_.target_viewpoint;
}

/// Judges the pose of the matches as it is.
Attempt Attempts::judged(CloudResult result) {
  const Similarity pose = result.registration.target_from_source;
  const Status status = result.registration.status;
  if (status == Status::Ok || status == Status::Degenerate) {
    judge_pose(result, *pair_, options_);
  } else {
    judge(result);
  }
  const double overlap = result.fitness + result.target_fitness;
  return {std::move(result), pose, {pose, false, 0, overlap}};
}

/// Judges the pose of the matches, or another one at which the surfaces meet best.
Attempt Attempts::refined(CloudResult result, const FrontendSetting& setting) {
  if (result.registration.status != Status::Ok) return judged(std::move(result));
  StageClock clock(result.registration.diagnostics.stages);
  begin_stage(options_, "comparison");
  if (setting.turns_source) {
    judge_by_voxels_of(result.matches);
    result.voxels = voxels_;
  }
  if (!hypotheses_) {
    hypotheses_.emplace(pair_, voxels_.target_voxel_size, options_, deadline_);
  }
  const Similarity matched = result.registration.target_from_source;
  Candidate candidate = hypotheses_->best_of(result.registration);
  result = take(std::move(result), candidate, *pair_, options_);
  if (setting.turns_source && result.verdict != Verdict::Trusted) {
    std::vector<Similarity> poses = poses_by_views(
        {voxels_.source, voxels_.target, voxels_.target_voxel_size, frontend_.target_viewpoint},
        options_, deadline_);
    if (best_.result.registration.status == Status::Ok) {
      poses.push_back(best_.candidate.target_from_source);
    }
    hypotheses_->expect_no_matches();
    candidate = hypotheses_->best_with(poses);
    result.found_by_turning = true;
    result.rivals = rivals_of(result, candidate);
    result = take(std::move(result), candidate, *pair_, options_);
  }
  clock.lap("comparison");
  return {std::move(result), matched, candidate};
}

/// The pose of an attempt with the matches that speak for it more clearly, its own or those of the
/// other one.
Attempt Attempts::with_clearer_matches(Attempt attempt, const CloudResult& other) {
  if (other.registration.status != Status::Ok) return attempt;
  CloudResult by_other = other;
  by_other.voxels = voxels_;
  by_other.found_by_turning = attempt.result.found_by_turning;
  by_other.rivals = attempt.result.rivals;
  by_other = take(std::move(by_other), attempt.candidate, *pair_, options_);
  const auto key = [](const CloudResult& result) {
    return std::tuple(-static_cast<int>(result.verdict), result.distinct_evidence);
  };
  if (key(by_other) > key(attempt.result)) attempt.result = std::move(by_other);
  return attempt;
}

/// Keeps the better one of the best and the next attempt, each with the matches of either.
void Attempts::keep_better(Attempt next, const FrontendSetting& setting) {
  const bool has_pose = refines() && next.result.registration.status == Status::Ok;
  // where the source was turned, the best was looked at again
  const bool is_better = better(next, best_) || (has_pose && setting.turns_source);
  if (!has_pose) {
    if (!is_better) return;
    best_ = std::move(next);
  } else if (is_better) {
    best_ = with_clearer_matches(std::move(next), best_.result);
  } else if (hypotheses_->are_one(next.candidate, best_.candidate)) {
    best_ = with_clearer_matches(std::move(best_), next.result);
  } else {
    return;
  }
  best_setting_ = setting;
}

bool Attempts::add(const FrontendSetting& setting) {
  auto tried = match(setting);
  if (!tried) {
    limits_.push_back({Limit::Memory, "the memory budget kept out an attempt with more matches"});
    return false;
  }
  Attempt next = refines() ? refined(std::move(*tried), setting) : judged(std::move(*tried));
  note_limits(next.result);
  if (count_++ == 0) {
    best_ = std::move(next);
    best_setting_ = setting;
  } else {
    keep_better(std::move(next), setting);
  }
  return true;
}

void Attempts::note_limits(const CloudResult& result) {
  add_stages(stages_, result.matches.stages);
  add_stages(stages_, result.registration.diagnostics.stages);
  if (result.matches.share_compared < 1) {
    const long percent = std::lround(100 * result.matches.share_compared);
    limits_.push_back({Limit::Time, "the time budget ended the matching after " +
                                        std::to_string(percent) + " % of the source"});
  }
}

bool Attempts::may_show_object() const {
  if (!pair_ || !refines() || options_.scale_mode == ScaleMode::Estimated ||
      frontend_.orientation != NormalOrientation::Automatic ||
      is_viewpoint_unknown(target_.points(), frontend_.target_viewpoint)) {
    return false;
  }
  return may_show(
      {voxels_.source, voxels_.target, voxels_.target_voxel_size, frontend_.target_viewpoint},
      options_.scale);
}

double Attempts::coarsening() const {
  if (frontend_.voxel_size > 0 || frontend_.source_voxel_size > 0) return 1;
  return std::max(coarsening_of(source_.points(), voxels_.source_voxel_size),
                  coarsening_of(target_.points(), voxels_.target_voxel_size));
}

void Attempts::know_mirrored_is_worse() {
  best_.result.mirrored_is_worse = true;
  judge(best_.result);
}

/// The pose that is clearly better by the surfaces, or better by both them and the matches, where
/// these were filtered and their agreement says something.
Candidate Attempts::preferred() {
  Candidate best = hypotheses_->challenged(best_.candidate);
  const double evidence_of_best = best_.result.distinct_evidence;
  if (best_.result.verdict != Verdict::Untrusted && !best_.result.found_by_turning &&
      best.overlap < kMuchBetter * best_.candidate.overlap &&
      evidence_of(best_.result, best, options_) < kSpeaksToo * evidence_of_best) {
    best = best_.candidate;
  }
  if (!best_.result.matches.filtered || best_.result.found_by_turning) return best;
  for (const Candidate& other : hypotheses_->better_than(best)) {
    const double evidence = evidence_of(best_.result, other, options_);
    if (evidence > evidence_of(best_.result, best, options_)) return other;
  }
  return best;
}

/// Looks at the rivals of the best, and takes one that is preferred to it.
void Attempts::compare_with_rivals() {
  StageClock clock(best_.result.registration.diagnostics.stages);
  const Similarity before = best_.candidate.target_from_source;
  best_.candidate = preferred();
  best_.result.rivals = rivals_of(best_.result, best_.candidate);
  if (best_.candidate.target_from_source.matrix() == before.matrix()) {
    judge(best_.result);
  } else {
    best_.result = take(std::move(best_.result), best_.candidate, *pair_, options_);
  }
  clock.lap("comparison");
}

/// Whether the mirrored source meets the target better than the source does at the best pose.
bool Attempts::fits_mirrored() const {
  Points points = voxels_.source;
  points.row(0) *= -1;
  const auto mirrored = std::make_shared<CentredPair>(
      points, voxels_.source_voxel_size, pair_->shared_target(), pair_->target_centre());
  SurfaceJudge judge(pair_, voxels_.target_voxel_size, options_);
  SurfaceJudge mirrored_judge(mirrored, voxels_.target_voxel_size, options_);
  const Similarity& pose = best_.candidate.target_from_source;
  const std::vector<Candidate> seen = mirrored_judge.peek(judge.reflections(pose), deadline_);
  const auto best = std::max_element(
      seen.begin(), seen.end(),
      [](const Candidate& a, const Candidate& b) { return a.overlap < b.overlap; });
  if (best->overlap < kWorthAGlance * best_.candidate.overlap) return false;
  const auto glanced = [&](SurfaceJudge& by, const Similarity& start) {
    return by.glance({start}, deadline_).front().overlap;
  };
  return glanced(mirrored_judge, best->target_from_source) > kFitsBetter * glanced(judge, pose);
}

const CloudResult& Attempts::compared() {
  if (best_.result.registration.status == Status::Ok) compare_with_rivals();
  return best_.result;
}

CloudResult Attempts::settled() {
  CloudResult& result = best_.result;
  result.num_attempts = count_;
  result.registration.diagnostics.stages = std::move(stages_);
  if (refines()) {
    result.refinement.method = "icp";
    result.refinement.note = "no pose to refine";
    if (result.registration.status == Status::Ok) {
      compare_with_rivals();
      if (result.verdict == Verdict::Trusted && options_.admit_all() && fits_mirrored()) {
        result.mirrored_is_better = true;
        judge(result);
      }
      result = settle(std::move(result), source_.points(), target_.points(), *pair_, best_.matched,
                      options_, deadline_);
    }
    // those that the caller asked for; poses of matches are none to one that they did not find
    auto& alternatives = result.registration.alternatives;
    const auto asked =
        result.found_by_turning ? 0 : static_cast<std::size_t>(options_.num_hypotheses - 1);
    alternatives.resize(std::min(alternatives.size(), asked));
  }
  auto& limits_hit = result.registration.diagnostics.limits_hit;
  limits_hit.insert(limits_hit.end(), limits_.begin(), limits_.end());
  return std::move(result);
}

}  // namespace gmcr::frontend
