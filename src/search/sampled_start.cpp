#include "search/sampled_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "estimation/fits/constrained_fit.hpp"
#include "geometry/elementary.hpp"
#include "kernels/points/residuals.hpp"
#include "problem/selection.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::search {
namespace {

constexpr Index kDrawsPerFit = 40;  ///< draws that take as long as a fit
constexpr Index kJudges = 1024;     ///< correspondences that a fit is judged on
constexpr double kNear = 2;         ///< bounds within which they suit: a fit to few is rough
constexpr double kMissed = 1e-6;    ///< chance that all draws missed a better pose
/// After this share of the draws a pose that could be decided has most likely been met.
constexpr double kPatience = 0.3;
constexpr Index kBetweenLooks = 4096;  ///< draws, at the clock

/// Scales at which a pair of correspondences agrees, of those in the range (L1).
ScaleRange agreeing_scales(const problem::Correspondences& c, Index i, Index j,
                           const ScaleRange& scales) {
  const double a = (c.source.col(j) - c.source.col(i)).norm();
  const double b = (c.target.col(j) - c.target.col(i)).norm();
  const double e = c.bounds[i] + c.bounds[j];
  if (!(a > 0)) return b <= e ? scales : ScaleRange{1, 0};
  return {std::max(scales.min, (b - e) / a), std::min(scales.max, (b + e) / a)};
}

/// Largest weight of each correspondence at the scales of the problem; none of those that agree
/// with most others by rounding alone.
std::vector<double> weights_of(const problem::Problem& problem) {
  std::vector<Index> all(static_cast<std::size_t>(problem.size()));
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<double> weights(all.size(), 0.0);
  for (const Index i : problem.clear_of_rounding(all)) {
    weights[static_cast<std::size_t>(i)] = problem.objective().weight(i, problem.scales().max);
  }
  return weights;
}

/// Draws of a few different correspondences, each as often as its weight says.
class Draws {
 public:
  Draws(const problem::Problem& problem, std::span<const double> weights)
      : problem_(problem), count_(problem.min_inliers()), weights_(weights) {}

  /// The next draw, if its members differ and agree pair by pair at one scale of the problem; else
  /// nothing.
  std::span<const Index> next() {
    ScaleRange scales = problem_.scales();
    for (Index m = 0; m < count_; ++m) {
      const Index drawn = draw_one();
      for (Index k = 0; k < m; ++k) {
        const Index member = members_[static_cast<std::size_t>(k)];
        if (member == drawn) return {};
        scales = agreeing_scales(problem_.correspondences(), member, drawn, scales);
        if (!(scales.min <= scales.max)) return {};
      }
      members_[static_cast<std::size_t>(m)] = drawn;
    }
    return {members_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  /// By rejection: a weight is at most 1.
  Index draw_one() {
    constexpr int kHalf = 32;
    for (;;) {
      const std::uint64_t bits = problem::mixed(num_drawn_++);
      const auto place = static_cast<std::size_t>(((bits >> kHalf) * weights_.size()) >> kHalf);
      const auto low = static_cast<double>(bits & std::numeric_limits<std::uint32_t>::max());
      if (low < std::ldexp(weights_[place], kHalf)) return static_cast<Index>(place);
    }
  }

  const problem::Problem& problem_;
  Index count_;
  std::span<const double> weights_;
  std::uint64_t num_drawn_ = 0;
  std::array<Index, problem::kMinInliers> members_{};
};

/// Some of the correspondences, spread evenly, to judge poses by.
class Judges {
 public:
  Judges(const problem::Correspondences& c, std::span<const double> weights)
      : chosen_(problem::stratified_selection(c.size(), kJudges)),
        source_(c.source(Eigen::all, chosen_).transpose()),
        target_(c.target(Eigen::all, chosen_).transpose()),
        squared_bounds_(c.bounds(chosen_).square()) {
    for (const Index i : chosen_) weights_.push_back(weights[static_cast<std::size_t>(i)]);
  }

  /// Weight of those that a pose suits.
  double score(const Similarity& pose) const {
    const auto near = kernels::consensus(pose, source_, target_, squared_bounds_, kNear * kNear);
    double score = 0;
    for (const Index k : near.indices) score += weights_[static_cast<std::size_t>(k)];
    return score;
  }

 private:
  std::vector<Index> chosen_;
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd squared_bounds_;
  std::vector<double> weights_;
};

/// Draws after which one from the inliers of a pose of more evidence alone was hardly missed.
/// @param total  of all weights.
double enough_draws(double evidence, double total, Index count) {
  // members differ: the others weigh 1 at most
  const double share = std::max(0.0, evidence - static_cast<double>(count - 1)) / total;
  const double all_inliers = elementary::pow(share, static_cast<double>(count));
  return all_inliers < 1 ? elementary::log(kMissed) / elementary::log1p(-all_inliers) : 1;
}

}  // namespace

SampledStart sampled_start(const problem::Problem& problem, const SamplingEffort& effort) {
  const problem::Correspondences& c = problem.correspondences();
  const std::vector<double> weights = weights_of(problem);
  double total = 0;
  for (const double weight : weights) total += weight;
  Draws draws(problem, weights);
  const Judges judges(c, weights);
  SampledStart start;
  std::vector<char> is_inlier(weights.size(), 0);
  double best_score = 0, enough = std::numeric_limits<double>::infinity();
  const auto max_draws = static_cast<double>(effort.max_draws);
  Index num_fits = 0;
  for (Index k = 0; k < effort.max_draws && num_fits * kDrawsPerFit <= effort.max_draws; ++k) {
    const auto drawn = static_cast<double>(k);
    if (drawn >= enough) {
      start.is_decisive = true;
      break;
    }
    if (start.best && drawn > kPatience * max_draws && enough > max_draws) break;
    if (k % kBetweenLooks == kBetweenLooks - 1 && effort.deadline.expired()) break;
    const std::span<const Index> members = draws.next();
    // those of the best pose would lead to it again
    if (std::all_of(members.begin(), members.end(),
                    [&](Index i) { return is_inlier[static_cast<std::size_t>(i)] != 0; })) {
      continue;
    }
    ++num_fits;
    const auto fit = estimation::fit_pose(c.source, c.target, c.bounds,
                                          {members.begin(), members.end()}, problem.constraints());
    if (!fit) continue;
    const double score = judges.score(*fit);
    if (start.best && score <= best_score) continue;
    best_score = score;
    auto fitted = refine::optimise_locally(problem, {*fit});
    if (!fitted || (start.best && !problem::is_better(*fitted, *start.best))) continue;
    start.best = std::move(fitted);
    best_score = std::max(best_score, judges.score(start.best->pose.similarity));
    std::fill(is_inlier.begin(), is_inlier.end(), 0);
    for (const Index i : start.best->inliers) is_inlier[static_cast<std::size_t>(i)] = 1;
    enough = enough_draws(start.best->evidence, total, problem.min_inliers());
  }
  return start;
}

}  // namespace gmcr::search
