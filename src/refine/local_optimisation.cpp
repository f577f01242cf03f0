#include "refine/local_optimisation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/fits/minimax_fit.hpp"
#include "problem/objective/measure.hpp"
#include "refine/pose_neighbourhood.hpp"

namespace gmcr::refine {
namespace {

/// Follows the pose of best score.
class Climb {
 public:
  Climb(const PoseNeighbourhood& near, const problem::CentredPose& start) : near_(near) {
    move_to(start);
    best_ = start;
    best_score_ = score_;
  }

  const problem::CentredPose& best() const { return best_; }
  std::vector<Index> inliers() const { return near_.within(squares_, 1); }
  double evidence_within(double factor) const {
    return near_.evidence(squares_, factor, pose_.scale());
  }

  /// Fits to those within `factor` of their bound. @return false where there is no fit.
  bool step(double factor) {
    const auto fit = near_.fit(squares_, factor);
    if (!fit) return false;
    move_to(*fit);
    if (score_.is_better_than(best_score_)) {
      best_ = pose_;
      best_score_ = score_;
    }
    return true;
  }

  /// Fits to the consensus set until it no longer changes.
  void settle() {
    constexpr int kMaxIterations = 20;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      const Eigen::Array<bool, Eigen::Dynamic, 1> before = squares_ <= 1;
      if (!step(1) || ((squares_ <= 1) == before).all()) return;
    }
  }

 private:
  void move_to(const problem::CentredPose& pose) {
    pose_ = pose;
    squares_ = near_.relative_squares(pose);
    score_ = near_.score(squares_, pose.scale());
  }

  const PoseNeighbourhood& near_;
  problem::CentredPose pose_, best_;
  Eigen::ArrayXd squares_;  // at pose_
  Score score_, best_score_;
};

/// Minimax fits over given correspondences, and the most evidence that they met.
class MinimaxClimb {
 public:
  MinimaxClimb(const problem::Problem& problem, std::vector<Index> indices,
               problem::Hypothesis best)
      : objective_(problem.objective()),
        indices_(std::move(indices)),
        best_(std::move(best)),
        fit_(problem.correspondences().source(Eigen::all, indices_),
             problem.correspondences().target(Eigen::all, indices_),
             problem.correspondences().bounds(indices_), problem.constraints()) {}

  const problem::Hypothesis& best() const { return best_; }

  /// Evidence of those that are not given up.
  double evidence() const { return objective_.evidence_of(indices_, best_.pose.scale()); }

  /// Fits until all are held. @return the least number that a fit did not hold.
  Index equalise(int max_iterations) {
    auto least_missing = static_cast<Index>(indices_.size());
    for (int iteration = 0; iteration < max_iterations && fit_.step(); ++iteration) {
      const auto holds = fit_.residuals() <= 1;
      const Index missing = fit_.residuals().size() - holds.count();
      weigh(fit_.pose().scale);
      if (problem::exceeds(holds.select(weights_, 0).sum(), best_.evidence)) {
        problem::Hypothesis next = objective_.judge({fit_.pose()});
        if (problem::is_better(next, best_)) best_ = std::move(next);
      }
      least_missing = std::min(least_missing, missing);
      if (missing == 0) break;
    }
    return least_missing;
  }

  /// Gives up the one that holds the fit back most.
  void give_up_heaviest() {
    Index heaviest = 0;
    fit_.weights().maxCoeff(&heaviest);
    fit_.leave_out(heaviest);
    indices_.erase(indices_.begin() + heaviest);
  }

 private:
  /// What each gives at a scale; the same at every scale but where copies are told by it.
  void weigh(double scale) {
    if (weights_.size() == std::ssize(indices_) && !objective_.weights_depend_on_scale()) return;
    Eigen::ArrayXd weights(std::ssize(indices_));  // a resize that fails would free the old twice
    std::transform(indices_.begin(), indices_.end(), weights.begin(),
                   [&](Index i) { return objective_.weight(i, scale); });
    weights_ = std::move(weights);
  }

  const problem::Objective& objective_;
  std::vector<Index> indices_;
  Eigen::ArrayXd weights_;
  problem::Hypothesis best_;
  estimation::MinimaxFit fit_;
};

}  // namespace

std::optional<problem::Hypothesis> optimise_locally(const problem::Problem& problem,
                                                    const problem::CentredPose& start,
                                                    const Incumbent& incumbent) {
  constexpr double kNear = 3;
  constexpr int kMaxRounds = 3;
  problem::Hypothesis best;
  problem::CentredPose pose = start;
  for (int round = 0; round < kMaxRounds; ++round) {
    const PoseNeighbourhood near(problem, pose, kNear);
    Climb climb(near, pose);
    if (round > 0) {
      climb.settle();
    } else if (climb.step(2) &&
               problem::exceeds(climb.evidence_within(1.5), incumbent.evidence())) {
      if (incumbent.is_exhausted && incumbent.is_near(climb.inliers())) return std::nullopt;
      if (climb.step(1.5)) climb.settle();
    }
    problem::Hypothesis next = problem.objective().judge(climb.best());
    if (round > 0 && !problem::is_better(next, best)) break;
    best = std::move(next);
    // others may have come near
    if (std::includes(near.indices().begin(), near.indices().end(), best.inliers.begin(),
                      best.inliers.end())) {
      break;
    }
    pose = best.pose;
  }
  return best;
}

problem::Hypothesis hold_more(const problem::Problem& problem, problem::Hypothesis best,
                              double must_exceed) {
  constexpr double kNear = 1.5;
  constexpr int kIterations = 20, kFurtherIterations = 5;
  constexpr Index kMaxGivenUp = 10;
  std::vector<Index> indices = problem.objective().within(best.pose, kNear);
  MinimaxClimb climb(problem, std::move(indices), std::move(best));
  for (Index left = kMaxGivenUp; left >= 0; --left) {
    if (!problem::exceeds(climb.evidence(), std::max(climb.best().evidence, must_exceed))) break;
    const Index missing = climb.equalise(left == kMaxGivenUp ? kIterations : kFurtherIterations);
    if (missing == 0 || missing > left) break;
    climb.give_up_heaviest();
  }
  return climb.best();
}

}  // namespace gmcr::refine
