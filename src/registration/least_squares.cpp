#include "registration/least_squares.hpp"

#include <utility>

#include "estimation/constrained_fit.hpp"

namespace gmcr {

Similarity fit_to_consensus(const Objective& objective, const PoseConstraints& constraints,
                            const Similarity& start) {
  constexpr int kMaxFits = 20;
  const Correspondences& c = objective.correspondences();
  Hypothesis current = objective.judge(start);
  for (int fits = 0; fits < kMaxFits; ++fits) {
    const auto fit = fit_pose(c.source, c.target, c.bounds, current.inliers, constraints);
    if (!fit) break;
    Hypothesis next = objective.judge(*fit);
    if (next.num_inliers() < kMinInliers) break;
    const bool is_settled = next.inliers == current.inliers;
    current = std::move(next);
    if (is_settled) break;
  }
  return current.target_from_source;
}

}  // namespace gmcr
