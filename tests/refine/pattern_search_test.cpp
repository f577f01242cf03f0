#include "refine/pattern_search.hpp"

#include <gtest/gtest.h>

#include "problems.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::refine {
namespace {

constexpr std::size_t kEnough = 1 << 20;

/// Inliers whose noise is almost as large as their bound, among outliers.
problem::Correspondences noisy(testing::Problem& problem, std::uint64_t seed) {
  testing::RandomGeometry random(seed);
  for (Index i = 0; i < 40; ++i) {
    problem.target.col(i) = problem.truth * problem.source.col(i) + random.in_ball(0.0099);
  }
  return {problem.source, problem.target, Eigen::ArrayXd::Constant(100, 0.01)};
}

TEST(ClimbByMotions, TakesInTheInliersThatAShiftLost) {
  Index before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto problem = testing::random_problem(seed, 40, 60);
    const problem::Correspondences c = noisy(problem, seed);
    const problem::Objective objective(c, Evidence::Count, kEnough);
    Similarity shifted = problem.truth;
    shifted.translation.x() += 0.003;
    const problem::Hypothesis fit = objective.judge(shifted);
    const problem::Hypothesis climbed =
        climb_by_motions(objective, estimation::PoseConstraints{{1, 1}}, fit);
    EXPECT_FALSE(problem::is_better(fit, climbed));
    EXPECT_EQ(climbed.inliers, objective.judge(climbed.target_from_source).inliers);
    EXPECT_EQ(climbed.target_from_source.scale, 1);
    const Eigen::Matrix3d& rotation = climbed.target_from_source.rotation;
    EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    before += fit.num_inliers();
    after += climbed.num_inliers();
  }
  EXPECT_LT(before, 700);
  EXPECT_GE(after, 20 * 40 - 20);
}

TEST(ClimbByMotions, KeepsTheScaleInItsRange) {
  auto problem = testing::random_problem(1, 40, 60);
  const problem::Correspondences c = noisy(problem, 1);
  const problem::Objective objective(c, Evidence::Count, kEnough);
  Similarity start = problem.truth;
  start.scale = 0.998;
  const ScaleRange scales{0.99, 0.999};
  const problem::Hypothesis judged = objective.judge(start);
  const problem::Hypothesis climbed =
      climb_by_motions(objective, estimation::PoseConstraints{scales}, judged);
  EXPECT_TRUE(problem::is_better(climbed, judged));
  EXPECT_NE(climbed.target_from_source.scale, start.scale);
  EXPECT_LE(climbed.target_from_source.scale, scales.max);
}

TEST(ClimbByMotions, LeavesAPoseAloneThatPriorsBindOrTooFewInliersMake) {
  auto problem = testing::random_problem(2, 40, 60);
  const problem::Correspondences c = noisy(problem, 2);
  const problem::Objective objective(c, Evidence::Count, kEnough);
  const problem::Hypothesis fit = *optimise_locally(objective, {1, 1}, problem.truth);
  estimation::PoseConstraints bound{{1, 1}};
  bound.priors.max_translation = 100;
  EXPECT_EQ(climb_by_motions(objective, bound, fit).target_from_source.matrix(),
            fit.target_from_source.matrix());
  Similarity far = problem.truth;
  far.translation.x() += 1e3;
  EXPECT_EQ(climb_by_motions(objective, estimation::PoseConstraints{{1, 1}}, objective.judge(far))
                .target_from_source.matrix(),
            far.matrix());
}

}  // namespace
}  // namespace gmcr::refine
