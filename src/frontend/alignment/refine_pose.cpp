#include "frontend/alignment/refine_pose.hpp"

#include <utility>
#include <vector>

#include "frontend/alignment/align.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kNarrowRadius = 1.5;  // cells
constexpr double kNarrowing = 0.7;
constexpr int kNarrowSteps = 12;
constexpr double kLeastKernel = 0.02;  // cells

/// Where a start is farther off than the matches leave it.
constexpr double kFarRadius = 4;  // cells
constexpr int kFarSteps = 3;

/// One step at each radius on the way from the reach to the narrowest, where it settles; a few
/// where the reach is far.
std::vector<AlignmentRound> rounds_of(RefinementScale scale) {
  std::vector<AlignmentRound> rounds;
  for (; scale.reach > kFarRadius; scale.reach *= kNarrowing) {
    rounds.push_back({scale.reach, kFarSteps, scale.least_step, kLeastKernel});
  }
  for (const double share : {1.0, kNarrowing, kNarrowing}) {
    const double radius = share * scale.reach;
    if (radius > kNarrowRadius) rounds.push_back({radius, 1, 0, kLeastKernel});
  }
  rounds.push_back({kNarrowRadius, kNarrowSteps, scale.least_step, kLeastKernel});
  for (AlignmentRound& round : rounds) {
    round.radius *= scale.cell;
    round.least_step *= scale.cell;
    round.least_kernel *= scale.cell;
  }
  return rounds;
}

AlignmentRules rules_of(const CentredPair& pair, const Options& options,
                        const parallel::Deadline& deadline) {
  AlignmentRules rules;
  rules.estimates_scale = options.scale_mode == ScaleMode::Estimated;
  rules.admits = [&](const Similarity& centred) {
    const auto& range = options.scale_range;
    if (range && (centred.scale < range->min || centred.scale > range->max)) return false;
    return options.admit(pair.of_caller(centred));
  };
  rules.deadline = &deadline;
  rules.num_threads = options.num_threads;
  return rules;
}

}  // namespace

RefinedPose refine_pose(CentredPair& pair, const Similarity& start, const RefinementScale& scale,
                        const Options& options, const parallel::Deadline& deadline) {
  RefinedPose refined;
  refined.target_from_source = start;
  const Samples samples = choose_samples(pair.source, pair.target, scale.max_samples);
  const AlignmentRules rules = rules_of(pair, options, deadline);
  const std::vector<AlignmentRound> rounds = rounds_of(scale);
  const Similarity before = pair.centred(start);
  Similarity after = before;
  for (const AlignmentRound& round : rounds) {
    after = align(pair.source, pair.target, samples, round, rules, after);
  }
  const AlignmentRound& last = rounds.back();
  const auto pairs_at = [&](const Similarity& pose) {
    return find_pairs(pair.source, pair.target, samples, pose, last.radius, options.num_threads);
  };
  PlanePairs pairs = pairs_at(after), first = pairs_at(before);
  refined.radius = last.radius;
  refined.kernel = kernel_of(pairs, last);
  refined.is_applied = mean_cost(pairs, refined.kernel) < mean_cost(first, refined.kernel);
  refined.pairs = std::move(refined.is_applied ? pairs : first);
  if (!refined.is_applied) return refined;
  refined.noise = estimate_noise(refined.pairs);
  refined.target_from_source = pair.of_caller(after);
  return refined;
}

}  // namespace gmcr::frontend
