#include "problem/objective.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "problems.hpp"
#include "proof/certificate.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::problem {
namespace {

constexpr std::size_t kEnough = 1 << 20;

TEST(Objective, JudgesByTheNumberOfInliersWhenTheEvidenceIsCount) {
  const auto problem = testing::random_problem(1, 20, 30);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(50, 0.01)};
  const Objective objective(c, Evidence::Count, kEnough);
  const Hypothesis truth = objective.judge(problem.truth);
  EXPECT_EQ(truth.num_inliers(), 20);
  EXPECT_EQ(truth.evidence, 20);
  EXPECT_EQ(truth.inliers, objective.within(problem.truth, 1));
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
  const Objective objective(c, Evidence::Distinct, kEnough);
  EXPECT_NEAR(objective.judge(problem.truth).evidence, 5, 1e-12);
  EXPECT_EQ(objective.judge(problem.truth).num_inliers(), 10);
}

TEST(Objective, WeighsAtAKnownScaleAsInARange) {
  const auto problem = testing::random_problem(4, 30, 60);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(90, 0.1)};
  const Objective all(c, Evidence::Distinct, kEnough);
  const Objective known(c, Evidence::Distinct, kEnough, {1, 1});
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
  EXPECT_EQ(Objective(c, Evidence::Count, kEnough).judge(pose).num_inliers(), 0);
}

TEST(EvaluateConsensus, RefusesAPoseThatIsNone) {
  const auto problem = testing::random_problem(2, 10, 0);
  Similarity pose = problem.truth;
  pose.scale = 0;
  EXPECT_THROW(evaluate_consensus(pose, problem.source, problem.target, problem.options()),
               std::invalid_argument);
  pose.scale = std::nan("");
  EXPECT_THROW(
      evaluate_uncertainty(pose, problem.source, problem.target, {0, 1, 2}, problem.options()),
      std::invalid_argument);
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

TEST(OptimiseLocally, BringsAPoseNearTheTruthToAllInliers) {
  const auto problem = testing::random_problem(3, 40, 60);
  const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(100, 0.01)};
  const Objective objective(c, Evidence::Count, kEnough);
  Similarity start = problem.truth;
  start.translation += Eigen::Vector3d(0.012, 0, 0);
  ASSERT_LT(objective.judge(start).num_inliers(), 30);
  const Hypothesis best = *refine::optimise_locally(objective, {1, 1}, start);
  EXPECT_GE(best.num_inliers(), 36);
}

TEST(ReachForMore, TakesInTheInliersWhoseNoiseIsCloseToTheBound) {
  int before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto problem = testing::random_problem(seed, 40, 60);
    testing::RandomGeometry random(seed);
    for (Index i = 0; i < 40; ++i) {
      problem.target.col(i) = problem.truth * problem.source.col(i) + 0.0099 * random.unit();
    }
    const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(100, 0.01)};
    const Objective objective(c, Evidence::Count, kEnough);
    const Hypothesis fit = *refine::optimise_locally(objective, {1, 1}, problem.truth);
    const Hypothesis more = refine::reach_for_more(objective, {1, 1}, fit);
    EXPECT_FALSE(is_better(fit, more));
    EXPECT_GE(more.num_inliers(), fit.num_inliers());
    EXPECT_EQ(more.inliers, objective.judge(more.target_from_source).inliers);
    const Hypothesis mean = objective.judge(
        refine::optimise_locally(objective, {1, 1}, more.target_from_source)->target_from_source);
    before += static_cast<int>(mean.num_inliers());
    after += static_cast<int>(more.num_inliers());
  }
  EXPECT_GE(after, before);
  EXPECT_GE(after, 20 * 40 - 20);
}

TEST(OptimiseLocally, IsNeverWorseThanItsStart) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto problem = testing::random_problem(seed, 5, 40);
    const Correspondences c{problem.source, problem.target, Eigen::ArrayXd::Constant(45, 0.1)};
    const Objective objective(c, Evidence::Distinct, kEnough);
    testing::RandomGeometry random(seed);
    const Similarity start = random.similarity(1, 1, 1);
    EXPECT_FALSE(
        is_better(objective.judge(start), *refine::optimise_locally(objective, {1, 1}, start)));
  }
}

TEST(MaxMembers, IsTheLargestSetWithThatManyPairs) {
  EXPECT_EQ(proof::max_members(0), 1);
  EXPECT_EQ(proof::max_members(1), 2);
  EXPECT_EQ(proof::max_members(2), 2);
  EXPECT_EQ(proof::max_members(3), 3);
  for (Index m = 2; m < 3000; m += 7) {
    EXPECT_EQ(proof::max_members(m * (m - 1) / 2), m);
    EXPECT_EQ(proof::max_members(m * (m - 1) / 2 - 1), m - 1);
  }
}

TEST(Certify, NeverBoundsBelowWhatWasAchieved) {
  EXPECT_TRUE(proof::certify(5, 5, 5, 5).certified);
  EXPECT_FALSE(proof::certify(5, 6, 5, 6).certified);
  EXPECT_EQ(proof::certify(5, 3, 4, 2).upper, 5);
  EXPECT_EQ(proof::certify(5, 3, 4, 2).evidence.upper, 4);
}

TEST(Certify, TakesTheNumberOfInliersForABoundOnTheirEvidence) {
  const Certificate certificate = proof::certify(5, 6, 3.5, 8);
  EXPECT_EQ(certificate.evidence.lower, 3.5);
  EXPECT_EQ(certificate.evidence.upper, 6);
  EXPECT_FALSE(certificate.evidence.certified);
  EXPECT_TRUE(proof::certify(5, 6, 3.5, 3.5 + 1e-12).evidence.certified);
}

}  // namespace
}  // namespace gmcr::problem
