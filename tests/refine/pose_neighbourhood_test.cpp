#include "refine/pose_neighbourhood.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"

namespace gmcr::refine {
namespace {

using testing::BuiltProblem;
using testing::options_with;

TEST(PoseNeighbourhood, ScoresAPoseAsTheObjectiveDoes) {
  const auto matches = testing::random_problem(1, 30, 71);
  for (const ScaleMode mode : {ScaleMode::Known, ScaleMode::Estimated}) {
    for (const Evidence evidence : {Evidence::Distinct, Evidence::Count}) {
      Options options = options_with(evidence);
      options.scale_mode = mode;
      options.scale_range = ScaleRange{0.5, 2};
      const BuiltProblem built(matches, options);
      problem::CentredPose moved = built.centred(matches.truth);
      const PoseNeighbourhood near(built.problem, moved, 3);
      moved.similarity.translation.x() += 0.005;
      const problem::Hypothesis judged = built.objective().judge(moved);
      const Eigen::ArrayXd squares = near.relative_squares(moved);
      EXPECT_EQ(near.within(squares, 1), judged.inliers);
      EXPECT_NEAR(near.score(squares, 1).evidence, judged.evidence, 1e-12);
      const auto num_far = static_cast<double>(101 - squares.size());
      EXPECT_NEAR(near.score(squares, 1).quadratic + num_far, judged.quadratic, 1e-10);
    }
  }
}

TEST(PoseNeighbourhood, FitsOnlyThoseWithinTheFactor) {
  const auto matches = testing::random_problem(2, 30, 70);
  const BuiltProblem built(matches, options_with(Evidence::Count));
  const problem::CentredPose truth = built.centred(matches.truth);
  const PoseNeighbourhood near(built.problem, truth, 3);
  const Eigen::ArrayXd squares = near.relative_squares(truth);
  EXPECT_TRUE(near.fit(squares, 1));
  EXPECT_FALSE(near.fit(squares, 1e-9));
  EXPECT_EQ(near.within(squares, 1e-9).size(), 0u);
}

}  // namespace
}  // namespace gmcr::refine
