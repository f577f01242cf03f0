#include "refine/local_optimisation.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"

namespace gmcr::refine {
namespace {

using testing::BuiltProblem;
using testing::options_with;

TEST(OptimiseLocally, BringsAPoseNearTheTruthToAllInliers) {
  const auto matches = testing::random_problem(3, 40, 60);
  const BuiltProblem built(matches, options_with(Evidence::Count));
  problem::CentredPose start = built.centred(matches.truth);
  start.similarity.translation += Eigen::Vector3d(0.012, 0, 0);
  ASSERT_LT(built.objective().judge(start).num_inliers(), 30);
  const problem::Hypothesis best = *optimise_locally(built.problem, start);
  EXPECT_GE(best.num_inliers(), 36);
}

TEST(OptimiseLocally, IsNeverWorseThanItsStart) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const BuiltProblem built(testing::random_problem(seed, 5, 40),
                             options_with(Evidence::Distinct, 0.1));
    testing::RandomGeometry random(seed);
    const problem::CentredPose start = built.centred(random.similarity(1, 1, 1));
    EXPECT_FALSE(problem::is_better(built.objective().judge(start),
                                    *optimise_locally(built.problem, start)));
  }
}

TEST(OptimiseLocally, LeavesTheSurroundingsOfAnExhaustedIncumbentAlone) {
  const auto matches = testing::random_problem(3, 40, 60);
  const BuiltProblem built(matches, options_with(Evidence::Count));
  const problem::CentredPose truth = built.centred(matches.truth);
  problem::Hypothesis incumbent = *optimise_locally(built.problem, truth);
  EXPECT_TRUE(optimise_locally(built.problem, truth, {&incumbent, false}));
  incumbent.evidence -= 10;  // so that the pose is worth a look
  EXPECT_FALSE(optimise_locally(built.problem, truth, {&incumbent, true}));
  incumbent.inliers.assign({96, 97, 98, 99});
  EXPECT_TRUE(optimise_locally(built.problem, truth, {&incumbent, true}));
}

TEST(HoldMore, TakesInTheInliersWhoseNoiseIsCloseToTheBound) {
  int before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto matches = testing::random_problem(seed, 40, 60);
    testing::RandomGeometry random(seed);
    for (Index i = 0; i < 40; ++i) {
      matches.target.col(i) = matches.truth * matches.source.col(i) + 0.0099 * random.unit();
    }
    const BuiltProblem built(matches, options_with(Evidence::Count));
    const problem::Hypothesis fit = *optimise_locally(built.problem, built.centred(matches.truth));
    const problem::Hypothesis more = hold_more(built.problem, fit);
    EXPECT_FALSE(problem::is_better(fit, more));
    EXPECT_GE(more.num_inliers(), fit.num_inliers());
    EXPECT_EQ(more.inliers, built.objective().judge(more.pose).inliers);
    const problem::Hypothesis mean =
        built.objective().judge(optimise_locally(built.problem, more.pose)->pose);
    before += static_cast<int>(mean.num_inliers());
    after += static_cast<int>(more.num_inliers());
  }
  EXPECT_GE(after, before);
  EXPECT_GE(after, 20 * 40 - 20);
}

TEST(Incumbent, OfFewMembersOrLittleEvidenceHasNothingNear) {
  problem::Hypothesis best;
  for (Index i = 0; i < 20; ++i) best.inliers.push_back(i);
  best.evidence = 20;
  const std::vector<Index> half{1, 2, 3, 24, 25, 26}, most{1, 2, 3, 4, 25, 26};
  EXPECT_TRUE((Incumbent{&best, true}.is_near(most)));
  EXPECT_FALSE((Incumbent{&best, true}.is_near(half)));
  best.evidence = 4;
  EXPECT_FALSE((Incumbent{&best, true}.is_near(most)));
  best.evidence = 8;
  best.inliers.resize(8);
  EXPECT_FALSE((Incumbent{&best, true}.is_near(most)));
  EXPECT_FALSE((Incumbent{}.is_near(most)));
}

}  // namespace
}  // namespace gmcr::refine
