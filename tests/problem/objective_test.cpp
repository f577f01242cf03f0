#include "problem/objective/objective.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "problems.hpp"

namespace gmcr::problem {
namespace {

constexpr std::size_t kEnoughMemory = 1 << 20;

TEST(Objective, JudgesByTheNumberOfInliersWhenTheEvidenceIsCount) {
  const auto problem = testing::random_problem(1, 20, 30);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(50, 0.01)};
  const Objective objective(c, Evidence::Count, kEnoughMemory);
  const Hypothesis truth = objective.judge({problem.truth});
  EXPECT_EQ(truth.num_inliers(), 20);
  EXPECT_EQ(truth.evidence, 20);
  EXPECT_EQ(truth.inliers, objective.within({problem.truth}, 1));
  EXPECT_GT(truth.quadratic, 30);
  EXPECT_LT(truth.quadratic, 50);
}

TEST(Objective, GivesCopiesOneVoteWhenTheEvidenceIsDistinct) {
  auto problem = testing::random_problem(2, 10, 0);
  for (Index i = 5; i < 10; ++i) {
    problem.source.col(i) = problem.source.col(0);
    problem.target.col(i) = problem.target.col(0);
  }
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(10, 0.01)};
  const Objective objective(c, Evidence::Distinct, kEnoughMemory);
  EXPECT_NEAR(objective.judge({problem.truth}).evidence, 5, 1e-12);
  EXPECT_EQ(objective.judge({problem.truth}).num_inliers(), 10);
}

TEST(Objective, WeighsAtAKnownScaleAsInARange) {
  const auto problem = testing::random_problem(4, 30, 60);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(90, 0.1)};
  const Objective all(c, Evidence::Distinct, kEnoughMemory);
  const Objective known(c, Evidence::Distinct, kEnoughMemory, {1, 1});
  ASSERT_TRUE(known.is_weighted());
  EXPECT_TRUE(all.weights_depend_on_scale());
  EXPECT_FALSE(known.weights_depend_on_scale());
  for (Index i = 0; i < 90; ++i) EXPECT_EQ(known.weight(i, 1), all.weight(i, 1));
}

TEST(Objective, TakesNoResidualThatIsNotANumberForAnInlier) {
  const auto problem = testing::random_problem(2, 10, 0);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(10, 0.01)};
  Similarity pose = problem.truth;
  pose.translation.x() = std::nan("");
  EXPECT_EQ(Objective(c, Evidence::Count, kEnoughMemory).judge({pose}).num_inliers(), 0);
}

TEST(IsBetter, PrefersMoreEvidenceAndThenACloserFit) {
  Hypothesis a, b;
  a.evidence = 3;
  b.evidence = 2;
  a.quadratic = 9;
  EXPECT_TRUE(is_better(a, b));
  EXPECT_FALSE(is_better(b, a));
  b.evidence = 3;
  EXPECT_TRUE(is_better(b, a));
  EXPECT_FALSE(is_better(a, a));
}

}  // namespace
}  // namespace gmcr::problem
