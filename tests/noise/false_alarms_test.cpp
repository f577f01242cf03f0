#include "noise/false_alarms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_geometry.hpp"

namespace gmcr::noise {
namespace {

double log10_choose(double n, double k) {
  return (std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)) / std::log(10.0);
}

TEST(PairDistances, AreThoseOfAllPairsOfAFewPoints) {
  Points points(3, 3);
  points << 0, 3, 0, 0, 0, 4, 0, 0, 0;
  const PairDistances distances(points);
  EXPECT_EQ(distances.median(), 4);
  EXPECT_NEAR(distances.share_within(3.5), 1.0 / 3, 1e-12);
  EXPECT_NEAR(distances.share_within(4.5), 2.0 / 3, 1e-12);
  EXPECT_EQ(distances.share_within(5), 1);
}

TEST(PairDistances, FollowThePowerOfTheDimensionBelowTheShortest) {
  testing::RandomGeometry random(1);
  const Points volume = random.in_cube(2000);
  Points surface = volume;
  surface.row(2).setZero();
  // small balls and discs inside the cube and the square
  const double radius = 1e-3, pi = 3.14159265;
  EXPECT_NEAR(std::log10(PairDistances(volume).share_within(radius)),
              std::log10(4 * pi / 3 * std::pow(radius, 3)), 0.6);
  EXPECT_NEAR(std::log10(PairDistances(surface).share_within(radius)),
              std::log10(pi * radius * radius), 0.4);
}

TEST(PairDistances, GrowWithTheRadius) {
  testing::RandomGeometry random(2);
  const PairDistances distances(random.in_cube(100));
  double last = 0;
  for (double radius = 1e-9; radius < 10; radius *= 1.3) {
    const double share = distances.share_within(radius);
    EXPECT_GE(share, last);
    EXPECT_GT(share, 0);
    last = share;
  }
  EXPECT_EQ(last, 1);
}

TEST(PairDistances, LeaveOutPointsThatCoincide) {
  const PairDistances none(Points::Constant(3, 10, 2.0));
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.median(), 0);
  EXPECT_EQ(none.share_within(1e-9), 1);
  Points twice(3, 4);
  twice << 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(PairDistances(twice).median(), 1);
  EXPECT_TRUE(PairDistances(Points(3, 0)).empty());
  EXPECT_TRUE(PairDistances(Points(3, 1)).empty());
}

TEST(CountFalseAlarms, FollowsTheFormula) {
  testing::RandomGeometry random(3);
  const Points cloud = random.in_cube(50);
  const PairDistances distances(cloud);
  Eigen::ArrayXd residuals(20);
  for (Index i = 0; i < 20; ++i) residuals[i] = random.uniform(0.01, 1);
  const FalseAlarms alarms =
      count_false_alarms(residuals, 1, distances, distances, distances, 1e-12);
  std::sort(residuals.begin(), residuals.end());
  ASSERT_EQ(alarms.log10.size(), 17u);
  for (int k = 4; k <= 20; ++k) {
    const auto m = static_cast<std::size_t>(k - 4);
    EXPECT_EQ(alarms.residuals[m], residuals[k - 1]);
    const double expected = std::log10(17.0) + log10_choose(20, k) + log10_choose(k, 3) +
                            (k - 3) * std::log10(distances.share_within(residuals[k - 1]));
    EXPECT_NEAR(alarms.log10[m], expected, 1e-9);
  }
}

TEST(CountFalseAlarms, OfThreeOrFewerIsEmpty) {
  const PairDistances distances(testing::RandomGeometry(4).in_cube(3));
  for (const Index count : {0, 1, 2, 3}) {
    EXPECT_TRUE(
        count_false_alarms(Eigen::ArrayXd::Zero(count), 1, distances, distances, distances, 1e-9)
            .empty());
  }
}

TEST(CountFalseAlarms, OfExactDataIsFiniteAndAgainstChance) {
  const PairDistances distances(testing::RandomGeometry(5).in_cube(50));
  const FalseAlarms alarms =
      count_false_alarms(Eigen::ArrayXd::Zero(50), 1, distances, distances, distances, 1e-12);
  EXPECT_TRUE(std::isfinite(alarms.log10.back()));
  EXPECT_LT(alarms.log10.back(), -100);
  EXPECT_EQ(alarms.residuals.front(), 1e-12);
}

TEST(CountFalseAlarms, OfAPoseThatShrinksTheSourceOntoAPointAreMany) {
  // every residual of a tiny copy of the source in the middle of the targets is small
  testing::RandomGeometry random(6);
  const Points source = random.in_cube(50), target = random.in_cube(50);
  const Eigen::ArrayXd residuals = Eigen::ArrayXd::Constant(50, 0.01);
  const auto least = [&](double scale) {
    const FalseAlarms alarms =
        count_false_alarms(residuals, scale, PairDistances(source), PairDistances(target),
                           PairDistances(scale * source, target), 1e-12);
    return *std::min_element(alarms.log10.begin(), alarms.log10.end());
  };
  EXPECT_LT(least(1), -10);
  const Points near = 0.005 * target;  // where all targets are near it, chance explains all
  const FalseAlarms alarms =
      count_false_alarms(residuals, 0.005, PairDistances(source), PairDistances(near),
                         PairDistances(0.005 * source, near), 1e-12);
  EXPECT_GT(*std::min_element(alarms.log10.begin(), alarms.log10.end()), 0);
}

TEST(CountFalseAlarms, ClusterOfTargetsWhereNoImageIsExplainsNothing) {
  testing::RandomGeometry random(7);
  const Points source = random.in_cube(60);
  Points target = source;
  for (Index i = 20; i < 60; ++i) {
    target.col(i) = Eigen::Vector3d(3, 3, 3) + random.in_ball(0.01);
  }
  const PairDistances from(source), to(target), between(source, target);
  const Eigen::ArrayXd residuals = (source - target).colwise().norm();
  const double with = count_false_alarms(residuals, 1, from, to, between, 1e-3).log10[16];
  const double without = count_false_alarms(residuals, 1, from, to, to, 1e-3).log10[16];
  EXPECT_LT(with, -30);
  EXPECT_GT(without, with + 10);
}

}  // namespace
}  // namespace gmcr::noise
