#include "noise/noise_bound_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimation/fits/prior_projection.hpp"
#include "geometry/elementary.hpp"
#include "paper/paper_method.hpp"
#include "problem/problem.hpp"
#include "search/best_poses.hpp"

namespace gmcr::noise {
namespace {

// Rungs, as shares of the median distance of the targets.
constexpr double kLowestRung = 3.1622776601683795e-4;  // 1e-3.5
constexpr double kHighestRung = 0.1;
constexpr double kRungRatio = 2;
constexpr int kMaxRounds = 3;        // from the residuals of a pose to a pose and so on
constexpr double kSameBound = 1.01;  // ratio of bounds that differ no more

// Matches that are off by more than the noise, but not by much, make loose bounds the surest. The
// bound is the tightest that is half as sure, times the factor that makes up for it where noise is
// uniform in a ball and the number of inliers grows with the third power of the radius.
constexpr double kSureShare = 0.5;
constexpr double kBallFactor = 1.2599210498948732;  // cbrt(1 / kSureShare)

// What a trial may cost.
constexpr std::uint64_t kMaxNodes = 2000;  // clique search nodes a graph
constexpr double kMaxDegree = 200;         // expected number of neighbours by chance
constexpr Index kFirstSelection = 300;     // correspondences to begin with
constexpr Index kSelectionGrowth = 4;
constexpr Index kMostOfUnknownScale = 1200;
constexpr double kSureLog10 = -10;  // false alarms of a consensus that needs no second look

constexpr Index kFirstCount = 4;  // of the sets that false alarms are counted of

/// A clique solver that gives up early: a rung needs a pose, not a proof.
class BudgetedCliqueSolver : public CliqueSolver {
 public:
  explicit BudgetedCliqueSolver(std::shared_ptr<const CliqueSolver> solver)
      : solver_(std::move(solver)) {}

  CliqueResult solve(const BitsetGraph& graph, const CliqueOptions& options) const override {
    CliqueOptions budgeted = options;
    budgeted.max_nodes = std::min(budgeted.max_nodes, kMaxNodes);
    return solver_ ? solver_->solve(graph, budgeted) : max_clique(graph, budgeted);
  }

 private:
  std::shared_ptr<const CliqueSolver> solver_;
};

/// How far the two lengths of pairs of correspondences differ at a scale, for an even selection of
/// pairs; ascending.
std::vector<double> measure_length_differences(const Points& source, const Points& target,
                                               double scale) {
  constexpr Index kSample = 20'000;
  constexpr Index kStep = 7919;  // a prime, so that the distances along the order mix
  const Index n = source.cols();
  std::vector<double> differences;
  for (Index k = 0; k < kSample; ++k) {
    const Index i = k % n, j = (i + 1 + (k / n) * kStep % (n - 1)) % n;
    differences.push_back(std::abs((target.col(j) - target.col(i)).norm() -
                                   scale * (source.col(j) - source.col(i)).norm()));
  }
  std::sort(differences.begin(), differences.end());
  return differences;
}

/// Distance from the origin that few points exceed, whatever these are.
double typical_norm(const Points& points) {
  constexpr double kMost = 0.9;
  const Eigen::RowVectorXd norms = points.colwise().norm();
  std::vector<double> sorted(norms.begin(), norms.end());
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>(kMost * (points.cols() - 1));
  std::nth_element(sorted.begin(), most, sorted.end());
  return *most;
}

/// The pose that holds the most, between the caller's frames, if it holds 3.
std::optional<Similarity> find_pose(const problem::Problem& problem, problem::Run& run) {
  if (problem.is_too_small()) return std::nullopt;
  const problem::Found found = problem.options().method == Method::Paper
                                   ? paper::solve(problem, run)
                                   : search::BestPoseSearch(problem, run).found();
  if (found.poses.empty()) return std::nullopt;
  const auto pose = estimation::admitted_pose(
      problem::uncentre(found.poses.front(), problem.correspondences()).similarity,
      problem.options());
  if (!pose) return std::nullopt;
  const problem::CallerObjective count(problem.input(), Evidence::Count, 0);
  return count.judge({*pose}).num_inliers() < problem::kMinInliers ? std::nullopt : pose;
}

}  // namespace

NoiseBoundSearch::NoiseBoundSearch(const PointsRef& source, const PointsRef& target,
                                   const Options& options)
    : options_(options),
      deadline_(options.time_limit / 2, options.stop),
      source_(source),
      target_(target),
      source_distances_(source_),
      target_distances_(target_),
      clique_solver_(std::make_shared<BudgetedCliqueSolver>(options.clique_solver)) {
  const double from = source_distances_.median(), to = target_distances_.median();
  const double typical_scale = from > 0 && to > 0 ? to / from : 1;
  const double scale = options.scale_mode == ScaleMode::Known ? options.scale : typical_scale;
  length_differences_ = measure_length_differences(source_, target_, scale);
  const double digits = 64 * std::numeric_limits<double>::epsilon();
  rounding_ =
      std::max(digits * (typical_norm(target_) + scale * typical_norm(source_)), kLeastMagnitude);
}

void NoiseBoundSearch::run() {
  const bool scale_is_known = options_.scale_mode == ScaleMode::Known;
  Index most = std::min(source_.cols(), problem::Run(options_).num_in_memory());
  if (!scale_is_known) most = std::min(most, kMostOfUnknownScale);
  // far below a trial's share of the time, so that no choice of the search depends on the clock
  const double share = options_.time_limit / 8 / static_cast<double>(ladder().size() + kMaxRounds);
  while (most > problem::kLeastSample && problem::foreseen_seconds(most, scale_is_known) > share) {
    most -= most / 8;
  }
  for (Index size = std::min(kFirstSelection, most);;
       size = std::min(kSelectionGrowth * size, most)) {
    climb(size);
    if (size == most || late_ || cancelled_ || (choice_ && choice_->log10 < kSureLog10)) break;
  }
  for (int round = 0; round < kMaxRounds && choice_ && choice_->log10 < 0; ++round) {
    const double bound = chosen_bound();
    try_bound(bound, selection_size(bound, most));
    const double ratio = chosen_bound() / bound;
    if (ratio < kSameBound && 1 / ratio < kSameBound) break;
  }
}

/// Tries each rung with at most so many correspondences; forgets what was tried before.
void NoiseBoundSearch::climb(Index most) {
  trials_.clear();
  choice_.reset();
  const std::vector<double> rungs = ladder();
  num_steps_ = static_cast<double>(rungs.size() + kMaxRounds);
  for (const double rung : rungs) try_bound(rung, selection_size(rung, most));
}

std::vector<double> NoiseBoundSearch::ladder() const {
  const double unit = target_distances_.median();
  std::vector<double> rungs;
  const int count = 1 + static_cast<int>(elementary::log(kHighestRung / kLowestRung) /
                                         elementary::log(kRungRatio));
  rungs.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    rungs.push_back(std::max(kLowestRung * elementary::pow(kRungRatio, k) * unit, rounding_));
  }
  rungs.erase(std::unique(rungs.begin(), rungs.end()), rungs.end());
  return rungs;
}

/// How many correspondences to search with a bound, so that the graph stays sparse.
Index NoiseBoundSearch::selection_size(double bound, Index most) const {
  const auto end =
      std::upper_bound(length_differences_.begin(), length_differences_.end(), 2 * bound);
  const double density = static_cast<double>(end - length_differences_.begin()) /
                         static_cast<double>(length_differences_.size());
  if (density * static_cast<double>(most) <= kMaxDegree) return most;
  return std::min(most, std::max(static_cast<Index>(kMaxDegree / density), kFirstSelection));
}

Options NoiseBoundSearch::cheap_options(double bound) const {
  Options cheap = options_;
  cheap.noise_mode = NoiseMode::Given;
  cheap.noise_bound = bound;
  cheap.num_hypotheses = 1;
  cheap.certify = false;
  cheap.clique_solver = clique_solver_;
  cheap.progress = nullptr;
  const double steps_left = std::max(1.0, num_steps_ - static_cast<double>(trials_.size()));
  cheap.time_limit = std::max(deadline_.remaining() / steps_left, parallel::kLeastSeconds);
  return cheap;
}

/// Whether time and caller say so.
bool NoiseBoundSearch::may_go_on() {
  if (options_.progress && !cancelled_) {
    const double done = static_cast<double>(trials_.size()) / num_steps_;
    cancelled_ = !options_.progress({"noise_bound", std::min(done, 1.0)});
  }
  cancelled_ = cancelled_ || options_.stop.stop_requested();
  late_ = late_ || (!cancelled_ && deadline_.expired());
  return !cancelled_ && !late_;
}

/// Searches for a pose with a bound among `count` correspondences and judges it by all.
void NoiseBoundSearch::try_bound(double bound, Index count) {
  if (!may_go_on()) return;
  std::vector<Index> selected;
  for (Index k = 0; k < count; ++k) selected.push_back(k * source_.cols() / count);
  const Points source = source_(Eigen::all, selected), target = target_(Eigen::all, selected);
  const Options options = cheap_options(bound);
  problem::Run run(options);
  const problem::Problem problem(source, target, options, run, problem::Route::Whole);
  trials_.push_back({bound, find_pose(problem, run), {}});
  num_clique_nodes_ += run.diagnostics().num_clique_nodes;
  if (!trials_.back().pose) return;

  Trial& trial = trials_.back();
  const Points images = trial.pose->apply(source_);
  const Eigen::ArrayXd residuals = (target_ - images).colwise().norm();
  trial.alarms = count_false_alarms(residuals, trial.pose->scale, source_distances_,
                                    target_distances_, PairDistances(images, target_), rounding_);
  choose();
}

void NoiseBoundSearch::choose() {
  double least = std::numeric_limits<double>::infinity();
  for (const Trial& trial : trials_) {
    for (const double log10 : trial.alarms.log10) least = std::min(least, log10);
  }
  const double sure = least < 0 ? kSureShare * least : least;
  choice_.reset();
  for (std::size_t t = 0; t < trials_.size(); ++t) {
    const auto& [residuals, log10] = trials_[t].alarms;
    const auto first =
        std::find_if(log10.begin(), log10.end(), [&](double value) { return value <= sure; });
    if (first == log10.end()) continue;
    const auto m = static_cast<std::size_t>(first - log10.begin());
    if (choice_ && choice_->residual <= residuals[m]) continue;
    choice_ = {t, static_cast<Index>(m) + kFirstCount, residuals[m], *first};
  }
}

double NoiseBoundSearch::chosen_bound() const {
  if (!choice_) return std::min(ladder().back(), kLargestMagnitude);
  // a fit takes its parameters' share from the residuals of the points it was fitted to
  const double num_parameters = options_.scale_mode == ScaleMode::Known ? 6 : 7;
  const double num_residuals = 3 * static_cast<double>(choice_->count);
  const double widening = std::sqrt(num_residuals / (num_residuals - num_parameters));
  return std::clamp(choice_->residual * widening * kBallFactor, rounding_, kLargestMagnitude);
}

NoiseEstimate NoiseBoundSearch::estimate() const {
  const double noise_bound = chosen_bound();
  if (!choice_) return {noise_bound, noise_bound, noise_bound, 0};
  const auto [lowest, highest] = stable_bounds();
  return {noise_bound, lowest, highest, choice_->log10};
}

/// Whether a pose moves the consensus set of the best one by less than its bound, on average.
bool NoiseBoundSearch::is_best_pose(const Similarity& pose) const {
  const Points images = trials_[choice_->trial].pose->apply(source_);
  const Eigen::ArrayXd residuals = (target_ - images).colwise().norm();
  const Eigen::ArrayXd moved = (pose.apply(source_) - images).colwise().norm();
  const double bound = chosen_bound();
  const Eigen::ArrayXd is_inlier = (residuals <= bound).cast<double>();
  return (moved * is_inlier).sum() <= bound * is_inlier.sum();
}

/// The lowest and the highest bound around the chosen one such that all trials between led to the
/// best pose.
std::pair<double, double> NoiseBoundSearch::stable_bounds() const {
  const double bound = chosen_bound();
  double too_low = 0, too_high = std::numeric_limits<double>::infinity();
  for (const Trial& trial : trials_) {
    if (trial.pose && is_best_pose(*trial.pose)) continue;
    if (trial.bound <= bound) too_low = std::max(too_low, trial.bound);
    if (trial.bound >= bound) too_high = std::min(too_high, trial.bound);
  }
  std::pair<double, double> stable{bound, bound};
  for (const Trial& trial : trials_) {
    if (trial.bound <= too_low || trial.bound >= too_high) continue;
    stable = {std::min(stable.first, trial.bound), std::max(stable.second, trial.bound)};
  }
  return stable;
}

}  // namespace gmcr::noise
