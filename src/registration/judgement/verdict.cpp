#include "registration/judgement/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/elementary.hpp"
#include "geometry/units.hpp"
#include "noise/chance.hpp"
#include "problem/selection.hpp"
#include "registration/judgement/handedness.hpp"

namespace gmcr::registration {
namespace {

using problem::Problem;

// One false alarm in a million solves: the model of chance is a model.
constexpr double kTrustedLog10 = -6;
// Distinct evidence: matches that are copies of few say little, however many they are.
constexpr double kTrustedEvidence = 4.5;
// More correspondences than that are judged by a selection.
constexpr Index kMostJudged = 20'000;
constexpr Index kMostJudgedInHurry = 2000;
// Evidence of another pose over that of the pose, above which it may be meant as well.
constexpr double kAsGood = 0.9;
// Evidence of a match below which some may be copies of others, digit by digit.
constexpr double kManyCopies = 0.5;
// A reflection that holds more than the pose by this much is what the data are of.
constexpr double kReflected = 1.0 / 0.7;

/// The consensus set among all correspondences, or among a selection where they are many.
struct Selection {
  Points source, target;  ///< of the selection; empty where all were selected
  Eigen::ArrayXd bounds;
  std::vector<Index> inliers, others;  ///< of the selected ones

  Selection(const problem::CallerCorrespondences& all, const std::vector<Index>& all_inliers,
            Index most) {
    const std::vector<Index> selected = problem::stratified_selection(all.size(), most);
    inliers.reserve(selected.size());
    others.reserve(selected.size());
    auto inlier = all_inliers.begin();  // both ascend
    for (std::size_t k = 0; k < selected.size(); ++k) {
      while (inlier != all_inliers.end() && *inlier < selected[k]) ++inlier;
      const bool is_inlier = inlier != all_inliers.end() && *inlier == selected[k];
      (is_inlier ? inliers : others).push_back(static_cast<Index>(k));
    }
    if (static_cast<Index>(selected.size()) == all.size()) return;
    source = all.source(Eigen::all, selected);
    target = all.target(Eigen::all, selected);
    bounds = all.bounds(selected);
  }
};

/// Number of lengths between so many points.
int num_lengths(Index num_points) { return static_cast<int>(num_points * (num_points - 1) / 2); }

/// How many of the matches are no copy of another one.
double num_single(const problem::CallerCorrespondences& all, const std::vector<Index>& matches) {
  std::set<std::array<double, 6>> single;
  for (const Index i : matches) {
    const auto a = all.source.col(i), b = all.target.col(i);
    single.insert({a[0], a[1], a[2], b[0], b[1], b[2]});
  }
  return static_cast<double>(single.size());
}

/// Whether an even selection of matches is of nearest neighbours under the pose: for more than half
/// the target is the nearest one to where the pose puts the source, and about as far as the next
/// one is. That of a right match with noise is much nearer, or the noise makes others the nearest.
bool are_nearest(const Similarity& pose, const PointsRef& source, const PointsRef& target,
                 const std::vector<Index>& matches) {
  constexpr Index kLooks = 32;
  constexpr double kMostly = 0.5;
  constexpr double kAsFar = 0.3;  // mean of the squared ratio; of unrelated points a half and more
  double num_nearest = 0, sum = 0;
  const std::vector<Index> chosen = problem::stratified_selection(std::ssize(matches), kLooks);
  for (const Index k : chosen) {
    const Index i = matches[static_cast<std::size_t>(k)];
    const Eigen::Vector3d image = pose * source.col(i);
    const double own = (target.col(i) - image).squaredNorm();
    double next = std::numeric_limits<double>::infinity();
    for (Index j = 0; j < target.cols() && next >= own; ++j) {
      const double square = (target.col(j) - image).squaredNorm();
      if (square != own) next = std::min(next, square);
    }
    if (next < own) continue;
    ++num_nearest;
    sum += own / next;
  }
  return num_nearest > kMostly * static_cast<double>(chosen.size()) && sum > kAsFar * num_nearest;
}

/// What is known of a consensus set, and the odds of chance for sets of its pose.
class Odds {
 public:
  Odds(const Problem& problem, const Result& result)
      : selection_(problem.input(), result.inliers,
                   problem.is_hurried() ? kMostJudgedInHurry : kMostJudged),
        sample_size_(static_cast<int>(problem.min_inliers())),
        num_lengths_(std::max(0, num_lengths(sample_size_) - (problem.scale_is_known() ? 0 : 1))) {
    const bool is_all = selection_.source.cols() == 0;
    const problem::CallerCorrespondences judged =
        is_all ? problem.input()
               : problem::CallerCorrespondences{selection_.source, selection_.target,
                                                selection_.bounds};
    const Options& options = problem.options();
    const double scale = result.target_from_source.scale;
    const auto measure = [&](const auto& objective) {
      distinct_inliers_ = objective.evidence_of(selection_.inliers, scale);
      if (selection_.others.empty()) return;
      const double evidence = objective.evidence_of(selection_.others, scale);
      num_others_ = static_cast<double>(selection_.others.size());
      if (evidence < kManyCopies * num_others_) {
        // matches that were given several times are one each, and tell nothing of the others
        const auto inliers = static_cast<double>(selection_.inliers.size());
        num_others_ = num_single(judged, selection_.others);
        if (inliers > 0) single_inliers_ = num_single(judged, selection_.inliers) / inliers;
      }
      distinct_share_ = evidence / num_others_;
    };
    if (is_all && options.evidence == Evidence::Distinct && !problem.is_sampled() &&
        problem.size() == problem.input().size()) {
      measure(problem.objective());
    } else {
      measure(problem::CallerObjective(judged, Evidence::Distinct, options.memory_limit / 4,
                                       ScaleRange{scale, scale}, problem.buckets()));
    }
    chance_ = noise::measure_chance(judged, {result.target_from_source});
    share_ = static_cast<double>(judged.size()) / static_cast<double>(problem.input().size());
  }

  /// log10 for a set of so many of all correspondences.
  double log10_false_alarms(Index num_inliers) const {
    return noise::log10_false_alarms(
        share_ * static_cast<double>(num_inliers) * single_inliers_ * distinct_share_,
        (single_inliers_ * static_cast<double>(selection_.inliers.size()) + num_others_) *
            distinct_share_,
        sample_size_, num_lengths_, chance_);
  }

  double distinct_inliers() const { return distinct_inliers_; }

  /// Whether the matches are nearest neighbours under the pose, by those that do not agree with it:
  /// at least half as many as do.
  bool are_made_under(const Similarity& pose, const problem::CallerCorrespondences& all) const {
    constexpr double kFewest = 20;
    if (num_others_ < kFewest || 2 * selection_.others.size() < selection_.inliers.size()) {
      return false;
    }
    const bool is_all = selection_.source.cols() == 0;
    return are_nearest(pose, is_all ? PointsRef(all.source) : PointsRef(selection_.source),
                       is_all ? PointsRef(all.target) : PointsRef(selection_.target),
                       selection_.others);
  }

 private:
  Selection selection_;
  int sample_size_, num_lengths_;
  double share_ = 1, distinct_inliers_ = 0, distinct_share_ = 1;
  double num_others_ = 0, single_inliers_ = 1;  ///< without the copies of each
  noise::Chance chance_;
};

/// Of less than one false alarm.
std::string in_words(double log10) {
  if (log10 > -3) {
    return "chance would give this once in " +
           std::to_string(std::lround(elementary::pow(10, -log10)));
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
  return problem::median(std::move(distances));
}

/// Names what may be wrong with the data, where the sizes of the clouds say so.
std::string units_hint(const PointsRef& source, const PointsRef& target, const Options& options) {
  if (options.scale_mode != ScaleMode::Known) return {};
  const double from = options.scale * typical_distance(source);
  const double to = typical_distance(target);
  const std::string units = from > 0 && to > 0 ? geometry::units_of_ratio(to / from) : "";
  return units.empty() ? "" : "; by their sizes " + units;
}

bool is_ambiguous(const Result& result) {
  return !result.alternatives.empty() &&
         result.alternatives.front().evidence >= kAsGood * result.evidence;
}

}  // namespace

void judge(Result& result, const Problem& problem, problem::Run& run) {
  const problem::StageTimer timer(run, "verdict");
  const Odds odds(problem, result);
  const auto num_inliers = static_cast<Index>(result.inliers.size());
  result.log10_false_alarms = odds.log10_false_alarms(num_inliers);
  const auto is_more = [&](Index held) {
    return static_cast<double>(held) > kReflected * static_cast<double>(num_inliers);
  };
  // none holds more than all
  const Index reflected = is_more(problem.input().size())
                              ? reflected_inliers(problem.input(), {result.target_from_source},
                                                  result.inliers, problem.scales())
                              : 0;
  const bool is_reflected =
      is_more(reflected) && odds.log10_false_alarms(reflected) <= kTrustedLog10;
  result.verdict = Verdict::Untrusted;
  if (is_reflected) {
    result.verdict_reason = "a reflection holds " + std::to_string(reflected) +
                            " matches: one of the clouds seems to be left-handed";
  } else if (result.status == Status::Degenerate) {
    result.verdict_reason = "the pose is one of many: " + result.status_reason;
  } else if (result.log10_false_alarms >= 0) {
    result.verdict_reason = num_inliers <= problem.min_inliers()
                                ? std::to_string(num_inliers) + " matches alone prove nothing"
                                : "chance explains this: random matches would agree as well";
  } else if (result.log10_false_alarms > kTrustedLog10) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = in_words(result.log10_false_alarms);
  } else if (odds.distinct_inliers() < kTrustedEvidence) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = std::to_string(num_inliers) + " matches agree, worth " +
                            with_one_digit(odds.distinct_inliers()) +
                            " distinct ones: too few to be sure";
  } else if (is_ambiguous(result)) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = "ambiguous: another pose has as much evidence";
  } else if (odds.are_made_under(result.target_from_source, problem.input())) {
    result.verdict = Verdict::Untrusted;
    result.verdict_reason =
        "the matches are nearest neighbours under this pose: they agree because they were made so";
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
