#include "refine/least_squares.hpp"

#include <utility>

#include "estimation/constrained_fit.hpp"

namespace gmcr::refine {

problem::CentredPose fit_to_consensus(const problem::Problem& problem,
                                      const problem::CentredPose& start) {
  constexpr int kMaxFits = 20;
  const problem::Correspondences& c = problem.correspondences();
  problem::Hypothesis current = problem.objective().judge(start);
  for (int fits = 0; fits < kMaxFits; ++fits) {
    const auto fit =
        estimation::fit_pose(c.source, c.target, c.bounds, current.inliers, problem.constraints());
    if (!fit) break;
    problem::Hypothesis next = problem.objective().judge({*fit});
    if (next.num_inliers() < problem::kMinInliers) break;
    const bool is_settled = next.inliers == current.inliers;
    current = std::move(next);
    if (is_settled) break;
  }
  return current.pose;
}

problem::Found fit_to_consensus(const problem::Problem& problem, problem::Found found) {
  for (problem::CentredPose& pose : found.poses) pose = fit_to_consensus(problem, pose);
  return found;
}

}  // namespace gmcr::refine
