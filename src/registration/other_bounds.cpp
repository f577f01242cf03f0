#include "registration/other_bounds.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "gmcr/registration.hpp"
#include "noise/false_alarms.hpp"
#include "problem/problem.hpp"
#include "proof/certificate.hpp"

namespace gmcr::registration {
namespace {

struct OtherBound {
  double factor;
  const char* words;
};
constexpr OtherBound kOtherBounds[] = {{3, "3 times"}, {1.0 / 3, "a third of"}};

/// log10 of the false alarms, at the given bound and without one, above which chance may explain an
/// answer.
constexpr double kByChance = -3, kByChanceAtAny = -10;
/// Least that another answer must have without a bound.
constexpr double kSure = -6;

bool has_pose(const Result& result) {
  return result.status == Status::Ok || result.status == Status::Degenerate;
}

bool was_ended(const Result& result) {
  return std::any_of(result.diagnostics.limits_hit.begin(), result.diagnostics.limits_hit.end(),
                     [](const LimitHit& hit) {
                       return hit.limit == Limit::Time || hit.limit == Limit::Stopped ||
                              hit.limit == Limit::Memory;
                     });
}

bool may_be_surer_elsewhere(const Result& result, const Options& options) {
  return options.method == Method::Gmcr && options.scale_mode == ScaleMode::Known &&
         options.num_hypotheses == 1 && !options.certify && has_pose(result) &&
         !was_ended(result) && result.log10_false_alarms > kByChance;
}

Options with_bounds_times(double factor, const Options& options) {
  Options other = options;
  other.noise_bound *= factor;
  for (double& bound : other.noise_bounds) bound *= factor;
  return other;
}

/// Whether the bounds are what a solve takes.
bool has_magnitudes(const Options& options) {
  const auto has_magnitude = [](double bound) {
    return bound >= kLeastMagnitude && bound <= kLargestMagnitude;
  };
  return options.noise_bounds.empty()
             ? has_magnitude(options.noise_bound)
             : std::all_of(options.noise_bounds.begin(), options.noise_bounds.end(), has_magnitude);
}

/// The certificate of the given bound, by the pose of the result where that holds more there.
Certificate certificate_with(const Result& result, Certificate certificate) {
  if (std::ssize(result.inliers) <= certificate.lower ||
      result.evidence < certificate.evidence.lower) {
    return certificate;
  }
  Certificate raised = proof::certify(std::ssize(result.inliers), certificate.upper,
                                      result.evidence, certificate.evidence.upper);
  raised.target_from_source = result.target_from_source;
  raised.inliers = result.inliers;
  return raised;
}

/// Adds what a further solve took.
void add_work(Diagnostics& diagnostics, const Diagnostics& further) {
  constexpr const char* kStage = "other_bounds";
  auto& stages = diagnostics.stages;
  if (stages.back().name != kStage) stages.push_back({kStage, 0});
  stages.back().seconds += further.total_seconds;
  diagnostics.total_seconds += further.total_seconds;
  diagnostics.num_clique_nodes += further.num_clique_nodes;
}

}  // namespace

Result at_surest_bound(Result at_given, const PointsRef& source, const PointsRef& target,
                       const Options& options, const Solve& solve) {
  if (!may_be_surer_elsewhere(at_given, options)) return at_given;
  const noise::PoseAlarms alarms(source, target);
  double least = alarms.least_log10(at_given.target_from_source);
  if (least <= kByChanceAtAny) return at_given;
  Result surest = at_given;
  std::string where;
  Diagnostics work = at_given.diagnostics;
  for (const auto& [factor, words] : kOtherBounds) {
    Options other = with_bounds_times(factor, options);
    if (!has_magnitudes(other)) continue;
    other.time_limit = options.time_limit - work.total_seconds;
    if (!(other.time_limit > 0)) break;
    Result there = solve(source, target, other);
    add_work(work, there.diagnostics);
    if (was_ended(there)) break;
    if (!has_pose(there)) continue;
    const double log10 = alarms.least_log10(there.target_from_source);
    if (log10 > std::min(least, kSure)) continue;
    least = log10;
    Consensus consensus = evaluate_consensus(there.target_from_source, source, target, options);
    there.inliers = std::move(consensus.inliers);
    there.evidence = consensus.evidence;
    surest = std::move(there);
    where = words;
  }
  surest.diagnostics = std::move(work);
  if (where.empty()) return surest;
  surest.certificate = certificate_with(surest, std::move(at_given.certificate));
  if (std::ssize(surest.inliers) < problem::kMinInliers) {
    surest.verdict = std::max(surest.verdict, Verdict::Doubtful);
  }
  surest.verdict_reason +=
      "; that is at " + where + " the noise bound: at the bound itself chance explains what agrees";
  return surest;
}

}  // namespace gmcr::registration
