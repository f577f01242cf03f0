#include "refine/pose_neighbourhood.hpp"

#include <gtest/gtest.h>

#include "problems.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::refine {
namespace {

constexpr std::size_t kEnough = 1 << 20;

problem::Correspondences correspondences_of(const testing::Problem& problem) {
  return {problem.source, problem.target, Eigen::ArrayXd::Constant(problem.source.cols(), 0.01)};
}

TEST(NearSet, ScoresAPoseAsTheObjectiveDoes) {
  const auto problem = testing::random_problem(1, 30, 71);
  const problem::Correspondences c = correspondences_of(problem);
  for (const ScaleRange scales : {ScaleRange{1, 1}, ScaleRange{0.5, 2}}) {
    for (const Evidence evidence : {Evidence::Distinct, Evidence::Count}) {
      const problem::Objective objective(c, evidence, kEnough, scales);
      const NearSet near(objective, problem.truth, 3);
      Similarity moved = problem.truth;
      moved.translation.x() += 0.005;
      const problem::Hypothesis judged = objective.judge(moved);
      const Eigen::ArrayXd squares = near.relative_squares(moved);
      EXPECT_EQ(near.within(squares, 1), judged.inliers);
      EXPECT_NEAR(near.score(squares, 1).evidence, judged.evidence, 1e-12);
      const auto num_far = static_cast<double>(c.size()) - static_cast<double>(squares.size());
      EXPECT_NEAR(near.score(squares, 1).quadratic + num_far, judged.quadratic, 1e-10);
    }
  }
}

TEST(NearSet, FitsOnlyThoseWithinTheFactor) {
  const auto problem = testing::random_problem(2, 30, 70);
  const problem::Correspondences c = correspondences_of(problem);
  const problem::Objective objective(c, Evidence::Count, kEnough);
  const NearSet near(objective, problem.truth, 3);
  const Eigen::ArrayXd squares = near.relative_squares(problem.truth);
  EXPECT_TRUE(near.fit(squares, 1, {1, 1}));
  EXPECT_FALSE(near.fit(squares, 1e-9, {1, 1}));
  EXPECT_EQ(near.within(squares, 1e-9).size(), 0u);
}

TEST(OptimiseLocally, LeavesTheSurroundingsOfASettledRivalAlone) {
  const auto problem = testing::random_problem(3, 40, 60);
  const problem::Correspondences c = correspondences_of(problem);
  const problem::Objective objective(c, Evidence::Count, kEnough);
  problem::Hypothesis rival = *optimise_locally(objective, {1, 1}, problem.truth);
  EXPECT_TRUE(optimise_locally(objective, {1, 1}, problem.truth, {&rival, false}));
  rival.evidence -= 10;  // so that the pose is worth a look
  EXPECT_FALSE(optimise_locally(objective, {1, 1}, problem.truth, {&rival, true}));
  rival.inliers.assign({96, 97, 98, 99});
  EXPECT_TRUE(optimise_locally(objective, {1, 1}, problem.truth, {&rival, true}));
}

TEST(Rival, OfFewMembersOrLittleEvidenceHasNothingNear) {
  problem::Hypothesis best;
  for (Index i = 0; i < 20; ++i) best.inliers.push_back(i);
  best.evidence = 20;
  const std::vector<Index> half{1, 2, 3, 24, 25, 26}, most{1, 2, 3, 4, 25, 26};
  EXPECT_TRUE((Rival{&best, true}.is_near(most)));
  EXPECT_FALSE((Rival{&best, true}.is_near(half)));
  best.evidence = 4;
  EXPECT_FALSE((Rival{&best, true}.is_near(most)));
  best.evidence = 8;
  best.inliers.resize(8);
  EXPECT_FALSE((Rival{&best, true}.is_near(most)));
  EXPECT_FALSE((Rival{}.is_near(most)));
}

}  // namespace
}  // namespace gmcr::refine
