#include "refine/pattern_search.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::refine {
namespace {

using testing::BuiltProblem;
using testing::options_with;

/// Inliers whose noise is almost as large as their bound, among outliers.
testing::Problem noisy(std::uint64_t seed) {
  auto matches = testing::random_problem(seed, 40, 60);
  testing::RandomGeometry random(seed);
  for (Index i = 0; i < 40; ++i) {
    matches.target.col(i) = matches.truth * matches.source.col(i) + random.in_ball(0.0099);
  }
  return matches;
}

TEST(ClimbByMotions, TakesInTheInliersThatAShiftLost) {
  Index before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto matches = noisy(seed);
    const BuiltProblem built(matches, options_with(Evidence::Count));
    problem::CentredPose shifted = built.centred(matches.truth);
    shifted.similarity.translation.x() += 0.003;
    const problem::Hypothesis fit = built.objective().judge(shifted);
    const problem::Hypothesis climbed = climb_by_motions(built.problem, fit);
    EXPECT_FALSE(problem::is_better(fit, climbed));
    EXPECT_EQ(climbed.inliers, built.objective().judge(climbed.pose).inliers);
    EXPECT_EQ(climbed.pose.scale(), 1);
    const Eigen::Matrix3d& rotation = climbed.pose.similarity.rotation;
    EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    before += fit.num_inliers();
    after += climbed.num_inliers();
  }
  EXPECT_LT(before, 700);
  EXPECT_GE(after, 20 * 40 - 20);
}

TEST(ClimbByMotions, KeepsTheScaleInItsRange) {
  const auto matches = noisy(1);
  Options options = options_with(Evidence::Count);
  options.scale_mode = ScaleMode::Estimated;
  options.scale_range = ScaleRange{0.99, 0.999};
  const BuiltProblem built(matches, options);
  Similarity start = matches.truth;
  start.scale = 0.998;
  const problem::Hypothesis judged = built.objective().judge(built.centred(start));
  const problem::Hypothesis climbed = climb_by_motions(built.problem, judged);
  EXPECT_TRUE(problem::is_better(climbed, judged));
  EXPECT_NE(climbed.pose.scale(), start.scale);
  EXPECT_LE(climbed.pose.scale(), 0.999);
}

TEST(ClimbByMotions, LeavesAPoseAloneThatPriorsBindOrTooFewInliersMake) {
  const auto matches = noisy(2);
  Options options = options_with(Evidence::Count);
  const BuiltProblem free(matches, options);
  options.max_translation = 100;
  const BuiltProblem bound(matches, options);
  const problem::Hypothesis fit = *optimise_locally(bound.problem, bound.centred(matches.truth));
  EXPECT_EQ(climb_by_motions(bound.problem, fit).pose.similarity.matrix(),
            fit.pose.similarity.matrix());
  problem::CentredPose far = free.centred(matches.truth);
  far.similarity.translation.x() += 1e3;
  EXPECT_EQ(climb_by_motions(free.problem, free.objective().judge(far)).pose.similarity.matrix(),
            far.similarity.matrix());
}

}  // namespace
}  // namespace gmcr::refine
