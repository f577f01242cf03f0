#include "problem/correspondences.hpp"

#include <gtest/gtest.h>

#include "problem/selection.hpp"
#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

TEST(Centre, PutsBothMediansAtTheOrigin) {
  testing::RandomGeometry random(1);
  const Points source = random.in_cube(50).colwise() + Eigen::Vector3d(5, 6, 7);
  const Points target = random.in_cube(50).colwise() + Eigen::Vector3d(-1, 0, 1);
  const Correspondences c = centre(source, target, Eigen::ArrayXd::Ones(50));
  EXPECT_EQ(median_point(c.source), Eigen::Vector3d::Zero());
  EXPECT_EQ(median_point(c.target), Eigen::Vector3d::Zero());
  EXPECT_LT(((c.source.colwise() + c.source_origin) - source).norm(), 1e-12);
}

TEST(Centre, LosesNoDigitsOfMostPointsToAFewFarOnes) {
  testing::RandomGeometry random(4);
  Points points = random.in_cube(21);
  points.rightCols(9).setConstant(3.4e38);
  const Correspondences c = centre(points, points, Eigen::ArrayXd::Ones(21));
  for (Index i = 0; i < 12; ++i) {
    EXPECT_LT((c.source.col(i) + c.source_origin - points.col(i)).norm(), 1e-15);
  }
}

TEST(Centre, OfNothingIsNothing) {
  EXPECT_EQ(centre(Points(3, 0), Points(3, 0), Eigen::ArrayXd(0)).size(), 0);
}

TEST(Uncentre, TurnsACentredTransformIntoOneBetweenTheCallersFrames) {
  testing::RandomGeometry random(2);
  const Points source = random.in_cube(30).colwise() + Eigen::Vector3d(100, -20, 3);
  const Similarity truth = random.similarity(0.5, 2, 50);
  const Points target = truth.apply(source);
  const Correspondences c = centre(source, target, Eigen::ArrayXd::Ones(30));
  Similarity centred = truth;
  centred.translation = truth * c.source_origin - c.target_origin;
  EXPECT_LT((centred.apply(c.source) - c.target).norm(), 1e-10);
  const CallerPose pose = uncentre(CentredPose{centred}, c);
  EXPECT_LT((pose.similarity.translation - truth.translation).norm(), 1e-10);
  EXPECT_LT((centre(pose, c).similarity.translation - centred.translation).norm(), 1e-10);
}

TEST(Subset, KeepsTheOrderOfTheIndicesAndTheOrigins) {
  testing::RandomGeometry random(3);
  const Correspondences all =
      centre(random.in_cube(5), random.in_cube(5), Eigen::ArrayXd::LinSpaced(5, 1, 5));
  const Correspondences some = subset(all, {4, 1});
  EXPECT_EQ(some.source.col(0), all.source.col(4));
  EXPECT_EQ(some.target.col(1), all.target.col(1));
  EXPECT_EQ(some.bounds[0], 5);
  EXPECT_EQ(some.target_origin, all.target_origin);
}

TEST(MaxNorm, IsTheLongestColumn) {
  Points points(3, 2);
  points << 3, 1, 4, 0, 0, 0;
  EXPECT_DOUBLE_EQ(max_norm(points), 5);
  EXPECT_EQ(max_norm(Points(3, 0)), 0);
}

}  // namespace
}  // namespace gmcr::problem
