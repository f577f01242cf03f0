#include "registration/local_optimisation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/constrained_fit.hpp"

namespace gmcr {
namespace {

std::optional<Similarity> fit(const Objective& objective, const PoseConstraints& constraints,
                              const std::vector<Index>& indices) {
  const Correspondences& c = objective.correspondences();
  return fit_pose(c.source, c.target, c.bounds, indices, constraints);
}

/// Fits that approach the pose of least largest residual over `indices`.
/// @return the best pose met, or `best`; and the index that weighs most in the end.
std::pair<Hypothesis, Index> equalise(const Objective& objective,
                                      const PoseConstraints& constraints,
                                      const std::vector<Index>& indices, Hypothesis best) {
  constexpr int kIterations = 20;
  const Correspondences& c = objective.correspondences();
  Eigen::ArrayXd weights = Eigen::ArrayXd::Ones(static_cast<Index>(indices.size()));
  Eigen::ArrayXd weighted_bounds = c.bounds;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    weighted_bounds(indices) = c.bounds(indices) / weights.sqrt();
    const auto pose = fit_pose(c.source, c.target, weighted_bounds, indices, constraints);
    if (!pose) break;
    std::vector<Index> held;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const Index i = indices[k];
      const double relative = (c.target.col(i) - *pose * c.source.col(i)).norm() / c.bounds[i];
      if (relative <= 1) held.push_back(i);
      // a floor, so that a correspondence that fits well now can come back
      weights[static_cast<Index>(k)] *= std::max(relative, 1e-3);
    }
    if (objective.evidence_of(held, pose->scale) > best.evidence) {
      Hypothesis next = objective.judge(*pose);
      if (is_better(next, best)) best = std::move(next);
    }
    if (held.size() == indices.size()) break;
    weights /= weights.maxCoeff();
    weights = weights.max(1e-12);
  }
  Index heaviest = 0;
  weights.maxCoeff(&heaviest);
  return {std::move(best), heaviest};
}

/// Fits to the consensus set until it no longer changes.
Hypothesis to_fixed_point(const Objective& objective, const PoseConstraints& constraints,
                          Hypothesis best) {
  constexpr int kMaxIterations = 20;
  std::vector<Index> indices = best.inliers;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const auto pose = fit(objective, constraints, indices);
    if (!pose) break;
    Hypothesis next = objective.judge(*pose);
    const bool settled = next.inliers == indices;
    indices = next.inliers;
    if (is_better(next, best)) best = std::move(next);
    if (settled) break;
  }
  return best;
}

}  // namespace

Hypothesis optimise_locally(const Objective& objective, const PoseConstraints& constraints,
                            const Similarity& start) {
  Hypothesis best = objective.judge(start);
  Similarity pose = start;
  for (const double factor : {2.0, 1.5}) {
    const auto wider = fit(objective, constraints, objective.within(pose, factor));
    if (!wider) return best;
    pose = *wider;
  }
  Hypothesis widened = objective.judge(pose);
  if (is_better(widened, best)) best = std::move(widened);
  return to_fixed_point(objective, constraints, std::move(best));
}

Hypothesis reach_for_more(const Objective& objective, const PoseConstraints& constraints,
                          Hypothesis best, double must_exceed) {
  constexpr double kReach = 1.5;
  constexpr int kMaxGivenUp = 10;
  std::vector<Index> indices = objective.within(best.target_from_source, kReach);
  for (int given_up = 0; given_up <= kMaxGivenUp; ++given_up) {
    const double scale = best.target_from_source.scale;
    if (objective.evidence_of(indices, scale) <= std::max(best.evidence, must_exceed)) break;
    auto [next, heaviest] = equalise(objective, constraints, indices, std::move(best));
    best = std::move(next);
    indices.erase(indices.begin() + heaviest);
  }
  return best;
}

}  // namespace gmcr
