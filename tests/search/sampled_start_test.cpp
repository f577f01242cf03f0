#include "search/sampled_start.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::search {
namespace {

using testing::BuiltProblem;

double error_of(const BuiltProblem& built, const testing::Problem& matches,
                const std::optional<problem::CentredPose>& start) {
  if (!start) return 1e9;
  const auto pose = problem::uncentre(*start, built.problem.correspondences());
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
  EXPECT_EQ(sampled_start(one.problem)->similarity.matrix(),
            sampled_start(other.problem)->similarity.matrix());
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
  EXPECT_FALSE(sampled_start(built.problem));
}

}  // namespace
}  // namespace gmcr::search
