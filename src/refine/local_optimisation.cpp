#include "refine/local_optimisation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/minimax_fit.hpp"
#include "refine/pose_neighbourhood.hpp"

namespace gmcr::refine {
namespace {

/// Follows the pose of best score.
class Climb {
 public:
  Climb(const NearSet& near, const estimation::PoseConstraints& constraints,
        const Similarity& start)
      : near_(near), constraints_(constraints) {
    move_to(start);
    best_ = start;
    best_score_ = score_;
  }

  const Similarity& best() const { return best_; }
  std::vector<Index> inliers() const { return near_.within(squares_, 1); }
  double evidence_within(double factor) const {
    return near_.evidence(squares_, factor, pose_.scale);
  }

  /// Fits to those within `factor` of their bound. @return false where there is no fit.
  bool step(double factor) {
    const auto fit = near_.fit(squares_, factor, constraints_);
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
  void move_to(const Similarity& pose) {
    pose_ = pose;
    squares_ = near_.relative_squares(pose);
    score_ = near_.score(squares_, pose.scale);
  }

  const NearSet& near_;
  const estimation::PoseConstraints& constraints_;
  Similarity pose_, best_;
  Eigen::ArrayXd squares_;  // at pose_
  Score score_, best_score_;
};

/// A held sum, beyond its rounding, is more.
bool is_more(double evidence, double than) { return evidence > than * (1 + 1e-12); }

/// Minimax fits over given correspondences, and the most evidence that they met.
class Reach {
 public:
  Reach(const problem::Objective& objective, const estimation::PoseConstraints& constraints,
        std::vector<Index> indices, problem::Hypothesis best)
      : objective_(objective),
        indices_(std::move(indices)),
        best_(std::move(best)),
        fit_(objective.correspondences().source(Eigen::all, indices_),
             objective.correspondences().target(Eigen::all, indices_),
             objective.correspondences().bounds(indices_), constraints) {}

  const problem::Hypothesis& best() const { return best_; }

  /// Evidence of those that are not given up.
  double evidence() const {
    return objective_.evidence_of(indices_, best_.target_from_source.scale);
  }

  /// Fits until all are held. @return the least number that a fit did not hold.
  Index equalise(int max_iterations) {
    auto least_missing = static_cast<Index>(indices_.size());
    for (int iteration = 0; iteration < max_iterations && fit_.step(); ++iteration) {
      double held = 0;
      Index missing = 0;
      for (std::size_t k = 0; k < indices_.size(); ++k) {
        if (fit_.residuals()[static_cast<Index>(k)] <= 1) {
          held += objective_.weight(indices_[k], fit_.pose().scale);
        } else {
          ++missing;
        }
      }
      if (is_more(held, best_.evidence)) {
        problem::Hypothesis next = objective_.judge(fit_.pose());
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
  const problem::Objective& objective_;
  std::vector<Index> indices_;
  problem::Hypothesis best_;
  estimation::MinimaxFit fit_;
};

}  // namespace

std::optional<problem::Hypothesis> optimise_locally(const problem::Objective& objective,
                                                    const estimation::PoseConstraints& constraints,
                                                    const Similarity& start, const Rival& rival) {
  constexpr double kNear = 3;
  constexpr int kMaxRounds = 3;
  problem::Hypothesis best;
  Similarity pose = start;
  for (int round = 0; round < kMaxRounds; ++round) {
    const NearSet near(objective, pose, kNear);
    Climb climb(near, constraints, pose);
    if (round > 0) {
      climb.settle();
    } else if (climb.step(2) && is_more(climb.evidence_within(1.5), rival.evidence())) {
      if (rival.settled && rival.is_near(climb.inliers())) return std::nullopt;
      if (climb.step(1.5)) climb.settle();
    }
    problem::Hypothesis next = objective.judge(climb.best());
    if (round > 0 && !problem::is_better(next, best)) break;
    best = std::move(next);
    // others may have come near
    if (std::includes(near.indices().begin(), near.indices().end(), best.inliers.begin(),
                      best.inliers.end())) {
      break;
    }
    pose = best.target_from_source;
  }
  return best;
}

problem::Hypothesis hold_all(const problem::Objective& objective,
                             const estimation::PoseConstraints& constraints,
                             const std::vector<Index>& indices, problem::Hypothesis best) {
  constexpr int kIterations = 20;
  Reach reach(objective, constraints, indices, std::move(best));
  reach.equalise(kIterations);
  return reach.best();
}

problem::Hypothesis reach_for_more(const problem::Objective& objective,
                                   const estimation::PoseConstraints& constraints,
                                   problem::Hypothesis best, double must_exceed) {
  constexpr double kReach = 1.5;
  constexpr int kIterations = 20, kFurtherIterations = 5;
  constexpr Index kMaxGivenUp = 10;
  std::vector<Index> indices = objective.within(best.target_from_source, kReach);
  Reach reach(objective, constraints, std::move(indices), std::move(best));
  for (Index left = kMaxGivenUp; left >= 0; --left) {
    if (!is_more(reach.evidence(), std::max(reach.best().evidence, must_exceed))) break;
    const Index missing = reach.equalise(left == kMaxGivenUp ? kIterations : kFurtherIterations);
    if (missing == 0 || missing > left) break;
    reach.give_up_heaviest();
  }
  return reach.best();
}

}  // namespace gmcr::refine
