#include "refine/likely_pose.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "estimation/uncertainty/noise_mixture.hpp"
#include "refine/pose_neighbourhood.hpp"

namespace gmcr::refine {
namespace {

using estimation::NoiseMixture;

struct Fit {
  problem::CentredPose pose;
  double log_likelihood = -std::numeric_limits<double>::infinity();
};

/// Expectation maximisation over the pose and the noise at once.
/// @return nullopt where too few correspondences are right, or no pose is admitted.
std::optional<Fit> fit_with(NoiseMixture::Tails tails, const PoseNeighbourhood& near,
                            problem::CentredPose pose) {
  constexpr int kMaxFits = 50;
  constexpr double kSettled = 1e-3;
  Eigen::ArrayXd squares = near.relative_squares(pose);
  NoiseMixture noise(tails, squares);
  for (int fits = 0; fits < kMaxFits; ++fits) {
    const Eigen::ArrayXd right = noise.right(squares), weights = noise.weights(squares);
    if (right.sum() < problem::kMinInliers) return std::nullopt;
    const auto next = near.fit(right * weights);
    if (!next) return std::nullopt;
    pose = *next;
    const Eigen::ArrayXd moved = near.relative_squares(pose);
    const double before = noise.variance();
    noise.update(right, weights, moved);
    const bool is_settled = std::abs(noise.variance() - before) <= kSettled * before &&
                            (moved - squares).abs().maxCoeff() <= kSettled;
    squares = moved;
    if (is_settled) break;
  }
  return Fit{pose, noise.log_likelihood(squares)};
}

}  // namespace

problem::CentredPose most_likely_pose(const problem::Problem& problem,
                                      const problem::CentredPose& start) {
  const PoseNeighbourhood near(problem, start, NoiseMixture::kWindow);
  if (near.indices().size() < static_cast<std::size_t>(problem::kMinInliers)) return start;
  std::optional<Fit> best;
  for (const auto tails : {NoiseMixture::Tails::Light, NoiseMixture::Tails::Heavy}) {
    const std::optional<Fit> fit = fit_with(tails, near, start);
    if (fit && (!best || fit->log_likelihood > best->log_likelihood)) best = fit;
  }
  if (!best) return start;
  const std::vector<Index> before = problem.objective().within(start, 1);
  const std::vector<Index> after = problem.objective().within(best->pose, 1);
  const bool stays = static_cast<Index>(after.size()) >= problem::kMinInliers &&
                     problem::shares_most(before, after);
  return stays ? best->pose : start;
}

std::vector<problem::CentredPose> most_likely_poses(const problem::Problem& problem,
                                                    std::vector<problem::CentredPose> poses) {
  for (problem::CentredPose& pose : poses) pose = most_likely_pose(problem, pose);
  return poses;
}

}  // namespace gmcr::refine
