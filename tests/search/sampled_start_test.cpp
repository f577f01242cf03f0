#include "search/sampled_start.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::search {
namespace {

using testing::BuiltProblem;

double error_of(const BuiltProblem& built, const testing::Problem& matches,
                const SampledStart& start) {
  if (!start.best) return 1e9;
  const auto pose = problem::uncentre(start.best->pose, built.problem.correspondences());
  return mean_point_error(pose.similarity, matches.truth, matches.source);
}

TEST(SampledStart, IsNearTheTruthWhereManyMatchesAreRight) {
  for (const Index num_right : {3000, 1000, 300}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const auto matches = testing::random_problem(seed, num_right, 3000 - num_right);
      const BuiltProblem known(matches, matches.options());
      EXPECT_LT(error_of(known, matches, sampled_start(known.problem)), 0.05) << num_right;
      if (num_right < 1000) continue;
      const BuiltProblem unknown(matches, matches.options_with_unknown_scale());
      EXPECT_LT(error_of(unknown, matches, sampled_start(unknown.problem)), 0.05) << num_right;
    }
  }
}

TEST(SampledStart, IsTheSameEachTime) {
  const auto matches = testing::random_problem(4, 100, 200);
  const BuiltProblem one(matches, matches.options()), other(matches, matches.options());
  EXPECT_EQ(sampled_start(one.problem).best->pose.similarity.matrix(),
            sampled_start(other.problem).best->pose.similarity.matrix());
}

TEST(SampledStart, DrawsAsManyAsThePriorsLeaveToBeDetermined) {
  auto matches = testing::random_problem(5, 1, 0);
  Options options = matches.options();
  options.initial_pose = InitialPose{matches.truth, 0};
  const BuiltProblem built(matches, options);
  EXPECT_LT(error_of(built, matches, sampled_start(built.problem)), matches.noise_bound);
}

TEST(SampledStart, OfMatchesThatNeverAgreeIsNone) {
  Points source(3, 4), target(3, 4);
  source << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  target = 1000 * source;
  testing::Problem matches{source, target, {}};
  const BuiltProblem built(matches, matches.options());
  const SampledStart start = sampled_start(built.problem);
  EXPECT_FALSE(start.best);
  EXPECT_FALSE(start.is_decisive);
}

TEST(SampledStart, DecidesWhereItDrewOftenEnoughToMeetABetterPose) {
  for (const Index num_right : {3000, 1500, 600, 90}) {
    const auto matches = testing::random_problem(6, num_right, 3000 - num_right);
    const BuiltProblem built(matches, matches.options());
    const SampledStart start = sampled_start(built.problem);
    // a draw of right ones alone has a chance of 1, 1/8, 1/125 and 1/37000
    EXPECT_EQ(start.is_decisive, num_right >= 600) << num_right;
    if (start.is_decisive) {
      EXPECT_GE(start.best->num_inliers(), num_right * 9 / 10);
    }
    EXPECT_FALSE(sampled_start(built.problem, {10}).is_decisive && num_right < 3000);
  }
}

TEST(SampledStart, MaximisesTheEvidenceAndNotTheNumber) {
  // 400 right ones, and 600 copies of three wrong ones, which agree with a pose of their own
  auto matches = testing::random_problem(7, 400, 600);
  testing::RandomGeometry random(8);
  const Similarity wrong = random.similarity(1, 1, 1);
  for (Index i = 400; i < 1000; ++i) {
    matches.source.col(i) = matches.source.col(400 + i % 3) + random.in_ball(1e-3);
    matches.target.col(i) = wrong * matches.source.col(i);
  }
  const BuiltProblem built(matches, matches.options());
  const SampledStart start = sampled_start(built.problem);
  EXPECT_TRUE(start.is_decisive);
  EXPECT_LT(error_of(built, matches, start), matches.noise_bound);
  Options counting = matches.options();
  counting.evidence = Evidence::Count;
  const BuiltProblem counted(matches, counting);
  EXPECT_GE(sampled_start(counted.problem).best->num_inliers(), 600);
}

TEST(SampledStart, DrawsNothingThatIsRoundingAlone) {
  auto matches = testing::random_problem(10, 8, 1);
  matches.source.col(8) = matches.target.col(8) = Eigen::Vector3d(3e38, 0, 0);
  for (const auto& options : {matches.options(), matches.options_with_unknown_scale()}) {
    const BuiltProblem built(matches, options);
    const SampledStart start = sampled_start(built.problem);
    ASSERT_TRUE(start.best);
    EXPECT_EQ(start.best->num_inliers(), 8);
  }
}

TEST(SampledStart, EndsWithTheTime) {
  const auto matches = testing::random_problem(9, 0, 3000);
  const BuiltProblem built(matches, matches.options());
  EXPECT_FALSE(sampled_start(built.problem, {1'000'000'000, parallel::Deadline(1e-3)}).is_decisive);
}

}  // namespace
}  // namespace gmcr::search
