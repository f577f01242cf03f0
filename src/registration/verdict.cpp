#include "registration/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "geometry/units.hpp"
#include "noise/chance.hpp"
#include "noise/false_alarms.hpp"
#include "registration/handedness.hpp"

namespace gmcr::registration {
namespace {

using problem::CallerObjective;
using problem::Problem;

// One false alarm in a million solves: the model of chance is a model.
constexpr double kTrustedLog10 = -6;
// Distinct evidence: matches that are copies of few say little, however many they are.
constexpr double kTrustedEvidence = 4.5;
// A reflection that holds more than the pose by this much is what the data are of.
constexpr double kReflected = 1.0 / 0.7;

/// Evidence without copies.
struct Distinct {
  double inliers = 0, others = 0;
};

Distinct distinct_evidence(const Problem& problem, const Result& result) {
  std::vector<Index> all(static_cast<std::size_t>(problem.input().size())), others;
  std::iota(all.begin(), all.end(), Index{0});
  std::set_difference(all.begin(), all.end(), result.inliers.begin(), result.inliers.end(),
                      std::back_inserter(others));
  const double scale = result.target_from_source.scale;
  const Options& options = problem.options();
  if (options.evidence == Evidence::Distinct && problem.size() == problem.input().size()) {
    const problem::Objective& known = problem.objective();
    return {known.evidence_of(result.inliers, scale), known.evidence_of(others, scale)};
  }
  const CallerObjective on_input(problem.input(), Evidence::Distinct, options.memory_limit / 4,
                                 problem::DistinctEvidence::kAllScales, problem.buckets());
  return {on_input.evidence_of(result.inliers, scale), on_input.evidence_of(others, scale)};
}

double log10_false_alarms(const Problem& problem, const Result& result, double distinct_others) {
  const auto n = static_cast<double>(problem.input().size());
  const auto k = static_cast<double>(result.inliers.size());
  const double distinct_share = n > k ? distinct_others / (n - k) : 1;
  const noise::Chance chance = noise::measure_chance(problem.input(), {result.target_from_source});
  return noise::log10_false_alarms(k * distinct_share, n * distinct_share,
                                   problem.scale_is_known() ? 3 : 2, chance);
}

std::string odds(double log10) {
  if (log10 >= 0) return "chance explains this";
  if (log10 > -3) {
    return "chance would give this once in " + std::to_string(std::lround(std::pow(10, -log10)));
  }
  return "chance would give this once in 10^" + std::to_string(std::lround(std::floor(-log10)));
}

std::string with_one_digit(double value) {
  const std::string tenths = std::to_string(std::lround(10 * value));
  return tenths.size() == 1 ? "0." + tenths
                            : tenths.substr(0, tenths.size() - 1) + "." + tenths.back();
}

/// Names what may be wrong with the data, where the sizes of the clouds say so.
std::string units_hint(const PointsRef& source, const PointsRef& target, const Options& options) {
  if (options.scale_mode != ScaleMode::Known) return {};
  const double from = options.scale * noise::PairDistances(source).median();
  const double to = noise::PairDistances(target).median();
  const std::string units = from > 0 && to > 0 ? geometry::units_of_ratio(to / from) : "";
  return units.empty() ? "" : "; by their sizes " + units;
}

}  // namespace

void judge(Result& result, const Problem& problem, problem::Run& run) {
  const problem::StageTimer timer(run, "verdict");
  const Distinct distinct = distinct_evidence(problem, result);
  result.log10_false_alarms = log10_false_alarms(problem, result, distinct.others);
  const Index reflected = reflected_inliers(problem.input(), {result.target_from_source},
                                            result.inliers, problem.scales());
  const auto num_inliers = static_cast<double>(result.inliers.size());
  result.verdict = Verdict::Untrusted;
  if (static_cast<double>(reflected) > kReflected * num_inliers) {
    result.verdict_reason = "a reflection holds " + std::to_string(reflected) +
                            " matches: one of the clouds seems to be left-handed";
  } else if (result.status == Status::Degenerate) {
    result.verdict_reason = "the pose is one of many: " + result.status_reason;
  } else if (result.log10_false_alarms >= 0) {
    result.verdict_reason = odds(result.log10_false_alarms);
  } else if (result.log10_false_alarms > kTrustedLog10) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = odds(result.log10_false_alarms);
  } else if (distinct.inliers < kTrustedEvidence) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = "the inliers are worth " + with_one_digit(distinct.inliers) +
                            " distinct matches only: the others are copies of them";
  } else {
    result.verdict = Verdict::Trusted;
    result.verdict_reason = odds(result.log10_false_alarms);
  }
  if (result.verdict != Verdict::Trusted) {
    result.verdict_reason +=
        units_hint(problem.input().source, problem.input().target, problem.options());
  }
}

void judge_without_pose(Result& result, const PointsRef& source, const PointsRef& target,
                        const Options& options) {
  result.verdict = Verdict::Untrusted;
  result.verdict_reason =
      "there is no pose: " + result.status_reason + units_hint(source, target, options);
}

}  // namespace gmcr::registration
