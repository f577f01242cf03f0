#include "refine/least_squares.hpp"

#include <utility>

#include "estimation/constrained_fit.hpp"

namespace gmcr::refine {

Similarity fit_to_consensus(const problem::Objective& objective,
                            const estimation::PoseConstraints& constraints,
                            const Similarity& start) {
  constexpr int kMaxFits = 20;
  const problem::Correspondences& c = objective.correspondences();
  problem::Hypothesis current = objective.judge(start);
  for (int fits = 0; fits < kMaxFits; ++fits) {
    const auto fit =
        estimation::fit_pose(c.source, c.target, c.bounds, current.inliers, constraints);
    if (!fit) break;
    problem::Hypothesis next = objective.judge(*fit);
    if (next.num_inliers() < problem::kMinInliers) break;
    const bool is_settled = next.inliers == current.inliers;
    current = std::move(next);
    if (is_settled) break;
  }
  return current.target_from_source;
}

}  // namespace gmcr::refine
