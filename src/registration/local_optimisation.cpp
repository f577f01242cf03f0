#include "registration/local_optimisation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/constrained_fit.hpp"
#include "estimation/minimax_fit.hpp"

namespace gmcr {
namespace {

std::optional<Similarity> fit(const Objective& objective, const PoseConstraints& constraints,
                              const std::vector<Index>& indices) {
  const Correspondences& c = objective.correspondences();
  return fit_pose(c.source, c.target, c.bounds, indices, constraints);
}

/// Fits that approach the pose of least largest residual over `indices`.
/// @return the best pose met, or `best`; and the position in `indices` that weighs most in the end.
std::pair<Hypothesis, Index> equalise(const Objective& objective,
                                      const PoseConstraints& constraints,
                                      const std::vector<Index>& indices, Hypothesis best) {
  constexpr int kIterations = 20;
  const Correspondences& c = objective.correspondences();
  MinimaxFit fit(c.source(Eigen::all, indices), c.target(Eigen::all, indices), c.bounds(indices),
                 constraints);
  for (int iteration = 0; iteration < kIterations && fit.step(); ++iteration) {
    std::vector<Index> held;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      if (fit.residuals()[static_cast<Index>(k)] <= 1) held.push_back(indices[k]);
    }
    if (objective.evidence_of(held, fit.pose().scale) > best.evidence) {
      Hypothesis next = objective.judge(fit.pose());
      if (is_better(next, best)) best = std::move(next);
    }
    if (held.size() == indices.size()) break;
  }
  Index heaviest = 0;
  fit.weights().maxCoeff(&heaviest);
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

Hypothesis hold_all(const Objective& objective, const PoseConstraints& constraints,
                    const std::vector<Index>& indices, Hypothesis best) {
  return equalise(objective, constraints, indices, std::move(best)).first;
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
