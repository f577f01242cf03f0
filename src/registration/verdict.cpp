#include "registration/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "geometry/units.hpp"
#include "noise/chance.hpp"
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

/// Odds of chance for sets of correspondences of one pose.
class Odds {
 public:
  Odds(const Problem& problem, const Result& result, const Distinct& distinct)
      : count_(static_cast<double>(problem.input().size())),
        num_lengths_(problem.scale_is_known() ? 3 : 2),
        chance_(noise::measure_chance(problem.input(), {result.target_from_source})) {
    const double num_others = count_ - static_cast<double>(result.inliers.size());
    if (num_others > 0) distinct_share_ = distinct.others / num_others;
  }

  double log10_false_alarms(Index num_inliers) const {
    return noise::log10_false_alarms(static_cast<double>(num_inliers) * distinct_share_,
                                     count_ * distinct_share_, num_lengths_, chance_);
  }

 private:
  double count_ = 0, distinct_share_ = 1;
  int num_lengths_ = 3;
  noise::Chance chance_;
};

/// Of less than one false alarm.
std::string in_words(double log10) {
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

/// Median distance of an even selection of pairs, metres.
double typical_distance(const PointsRef& points) {
  constexpr Index kPairs = 1000;
  const Index n = points.cols(), count = std::min(n, kPairs);
  if (n < 2) return 0;
  std::vector<double> distances;
  for (Index k = 0; k < count; ++k) {
    const Index i = k * n / count;
    distances.push_back((points.col((i + n / 2) % n) - points.col(i)).norm());
  }
  const auto median = distances.begin() + count / 2;
  std::nth_element(distances.begin(), median, distances.end());
  return *median;
}

/// Names what may be wrong with the data, where the sizes of the clouds say so.
std::string units_hint(const PointsRef& source, const PointsRef& target, const Options& options) {
  if (options.scale_mode != ScaleMode::Known) return {};
  const double from = options.scale * typical_distance(source);
  const double to = typical_distance(target);
  const std::string units = from > 0 && to > 0 ? geometry::units_of_ratio(to / from) : "";
  return units.empty() ? "" : "; by their sizes " + units;
}

}  // namespace

void judge(Result& result, const Problem& problem, problem::Run& run) {
  const problem::StageTimer timer(run, "verdict");
  const Distinct distinct = distinct_evidence(problem, result);
  const Odds odds(problem, result, distinct);
  const auto num_inliers = static_cast<Index>(result.inliers.size());
  result.log10_false_alarms = odds.log10_false_alarms(num_inliers);
  const Index reflected = reflected_inliers(problem.input(), {result.target_from_source},
                                            result.inliers, problem.scales());
  const bool is_reflected =
      static_cast<double>(reflected) > kReflected * static_cast<double>(num_inliers) &&
      odds.log10_false_alarms(reflected) <= kTrustedLog10;
  result.verdict = Verdict::Untrusted;
  if (is_reflected) {
    result.verdict_reason = "a reflection holds " + std::to_string(reflected) +
                            " matches: one of the clouds seems to be left-handed";
  } else if (result.status == Status::Degenerate) {
    result.verdict_reason = "the pose is one of many: " + result.status_reason;
  } else if (result.log10_false_alarms >= 0) {
    result.verdict_reason = num_inliers <= problem::kMinInliers
                                ? "three matches alone prove nothing"
                                : "chance explains this: random matches would agree as well";
  } else if (result.log10_false_alarms > kTrustedLog10) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = in_words(result.log10_false_alarms);
  } else if (distinct.inliers < kTrustedEvidence) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = std::to_string(num_inliers) + " matches agree, worth " +
                            with_one_digit(distinct.inliers) + " distinct ones: too few to be sure";
  } else {
    result.verdict = Verdict::Trusted;
    result.verdict_reason = in_words(result.log10_false_alarms);
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
