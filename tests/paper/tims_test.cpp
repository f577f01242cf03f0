#include "paper/tims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_geometry.hpp"

namespace gmcr::paper {
namespace {

TEST(AllPairs, AreEveryUnorderedPairOnceInOrder) {
  EXPECT_TRUE(all_pairs(0).empty());
  EXPECT_TRUE(all_pairs(1).empty());
  const auto pairs = all_pairs(4);
  ASSERT_EQ(pairs.size(), 6u);
  EXPECT_EQ(pairs[1].first, 0);
  EXPECT_EQ(pairs[1].second, 2);
  EXPECT_EQ(pairs[5].first, 2);
  EXPECT_EQ(pairs[5].second, 3);
}

TEST(MakeTims, SubtractsTheFirstPointFromTheSecondAndAddsTheBounds) {
  testing::RandomGeometry random(1);
  const problem::Correspondences c{random.in_cube(3), random.in_cube(3), Eigen::Array3d(1, 2, 4)};
  const Tims tims = make_tims(c, {{1, 2}});
  EXPECT_EQ(tims.source.col(0), c.source.col(2) - c.source.col(1));
  EXPECT_EQ(tims.target.col(0), c.target.col(2) - c.target.col(1));
  EXPECT_EQ(tims.bounds[0], 6);
}

TEST(MakeTims, DoNotChangeWhenACloudIsMoved) {
  testing::RandomGeometry random(2);
  problem::Correspondences c{random.in_cube(10), random.in_cube(10), Eigen::ArrayXd::Ones(10)};
  const Tims before = make_tims(c, all_pairs(10));
  c.target.colwise() += Eigen::Vector3d(1, 2, 3);
  EXPECT_LT((make_tims(c, all_pairs(10)).target - before.target).norm(), 1e-14);
}

TEST(MeasureScales, GivesRatioAndIntervalOfL1) {
  Tims tims;
  tims.pairs = {{0, 1}};
  tims.source = Eigen::Vector3d(2, 0, 0);
  tims.target = Eigen::Vector3d(0, 6, 0);
  tims.bounds = Eigen::ArrayXd::Constant(1, 0.5);
  const ScaleMeasurements m = measure_scales(tims);
  EXPECT_DOUBLE_EQ(m.scale[0], 3);
  EXPECT_DOUBLE_EQ(m.alpha[0], 0.25);
  EXPECT_DOUBLE_EQ(m.lower[0], 2.75);
  EXPECT_DOUBLE_EQ(m.upper[0], 3.25);
}

TEST(MeasureScales, OfCoincidentSourcePointsAdmitsEveryScaleOrNone) {
  Tims tims;
  tims.pairs = {{0, 1}, {0, 2}};
  tims.source = Points::Zero(3, 2);
  tims.target = Points::Zero(3, 2);
  tims.target(0, 0) = 0.4;
  tims.target(0, 1) = 0.6;
  tims.bounds = Eigen::Array2d(0.5, 0.5);
  const ScaleMeasurements m = measure_scales(tims);
  EXPECT_EQ(m.lower[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(m.upper[0], std::numeric_limits<double>::infinity());
  EXPECT_GT(m.lower[1], m.upper[1]);
  EXPECT_TRUE(std::isinf(m.alpha[0]));
}

}  // namespace
}  // namespace gmcr::paper
