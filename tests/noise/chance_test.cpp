#include "noise/chance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_geometry.hpp"

namespace gmcr::noise {
namespace {

problem::CallerCorrespondences matches(const Points& source, const Points& target, double bound) {
  return {source, target, Eigen::ArrayXd::Constant(source.cols(), bound)};
}

TEST(ShareWithin, CountsWhereThereAreEnough) {
  std::vector<double> values;
  for (int i = 1000; i > 0; --i) values.push_back(i);
  EXPECT_DOUBLE_EQ(share_within(values, 250), 0.25);
  EXPECT_DOUBLE_EQ(share_within(values, 5000), 1);
}

TEST(ShareWithin, FollowsThePowerLawBelowTheLeast) {
  std::vector<double> values;  // share of a radius: its third power
  for (int i = 1; i <= 1000; ++i) values.push_back(std::cbrt(i / 1000.0));
  EXPECT_NEAR(std::log10(share_within(values, 0.01)), -6, 0.1);
  EXPECT_GT(share_within(values, 1e-9), 0);
}

TEST(ShareWithin, OfNothingIsAll) {
  std::vector<double> none;
  EXPECT_EQ(share_within(none, 1), 1);
  std::vector<double> zeros(50, 0.0);
  EXPECT_EQ(share_within(zeros, 1), 1);
}

TEST(MeasureChance, IsTheShareOfTheBallInTheCube) {
  testing::RandomGeometry random(1);
  const Points source = random.in_cube(20'000), target = random.in_cube(20'000);
  const Chance chance = measure_chance(matches(source, target, 0.1), {Similarity{}});
  // a ball of radius 0.1, less what is outside of the cube
  const double ball = 4 * std::numbers::pi / 3 * 1e-3;
  EXPECT_GT(chance.inlier, 0.7 * ball);
  EXPECT_LT(chance.inlier, 1.05 * ball);
  EXPECT_GT(chance.length, 0.1);
  EXPECT_LT(chance.length, 0.5);
}

TEST(MeasureChance, OfTargetsInAClusterAwayFromTheImagesIsSmall) {
  testing::RandomGeometry random(2);
  const Points source = random.in_cube(300);
  Points target = source;
  for (Index i = 30; i < 300; ++i) target.col(i) = Eigen::Vector3d(2, 0, 0) + random.in_ball(0.01);
  EXPECT_LT(measure_chance(matches(source, target, 0.02), {Similarity{}}).inlier, 1e-3);
}

TEST(MeasureChance, OfFewOrEqualPointsIsNeitherZeroNorMoreThanOne) {
  for (const Index count : {0, 1, 2, 3, 20}) {
    const Points points = Points::Constant(3, count, 1.0);
    const Chance chance = measure_chance(matches(points, points, 0.1), {Similarity{}});
    EXPECT_EQ(chance.inlier, 1);
    EXPECT_EQ(chance.length, 1);
  }
}

TEST(Log10FalseAlarms, FollowsTheFormula) {
  const double alpha = 0.05;
  double tail = 0;  // of at least 6 of 17
  for (int m = 6; m <= 17; ++m) {
    tail += std::exp(std::lgamma(18) - std::lgamma(m + 1) - std::lgamma(18 - m)) *
            std::pow(alpha, m) * std::pow(1 - alpha, 17 - m);
  }
  // C(20, 3) = 1140, C(9, 3) = 84
  for (const int num_lengths : {2, 3}) {
    EXPECT_NEAR(log10_false_alarms(9, 20, 3, num_lengths, {alpha, 0.1}),
                std::log10(1140.0 / 84 * tail) - num_lengths, 0.02);
  }
}

TEST(Log10FalseAlarms, CountAsManyAsTheMeanAsChance) {
  EXPECT_NEAR(log10_false_alarms(13, 103, 3, 3, {0.1, 1}), std::log10(176851.0 / 286), 1e-9);
}

TEST(Log10FalseAlarms, OfAllAreFinite) {
  EXPECT_NEAR(log10_false_alarms(20, 20, 3, 3, {0.1, 1}), -17, 1e-9);
  EXPECT_EQ(log10_false_alarms(20, 20, 3, 3, {1, 1}), 0);
}

TEST(Log10FalseAlarms, OfAMinimalSampleProvesNothing) {
  for (const double k : {0.0, 1.0, 2.5, 3.0}) {
    for (const double n : {3.0, 100.0}) {
      EXPECT_GE(log10_false_alarms(k, n, 3, 3, {1e-9, 1e-9}), 0);
    }
  }
}

TEST(Log10FalseAlarms, FallAsMoreAgree) {
  double last = 1;
  for (int k = 4; k <= 50; ++k) {
    const double now = log10_false_alarms(k, 50, 3, 3, {1e-3, 0.1});
    EXPECT_LT(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace gmcr::noise
