#include "geometry/close_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "random_geometry.hpp"

namespace gmcr::geometry {
namespace {

using Pairs = std::multiset<std::pair<Index, Index>>;

Pairs close_pairs(const Points& points, const Eigen::ArrayXd& radii) {
  Pairs pairs;
  EXPECT_TRUE(for_each_close_pair(points, radii, [&](Index i, Index j, double radius) {
    EXPECT_EQ(radius, 2 * std::min(radii[i], radii[j]));
    pairs.emplace(std::min(i, j), std::max(i, j));
    return true;
  }));
  return pairs;
}

Pairs pairs_by_definition(const Points& points, const Eigen::ArrayXd& radii) {
  Pairs pairs;
  for (Index i = 0; i < points.cols(); ++i) {
    for (Index j = i + 1; j < points.cols(); ++j) {
      const double radius = 2 * std::min(radii[i], radii[j]);
      if ((points.col(j) - points.col(i)).squaredNorm() <= radius * radius) pairs.emplace(i, j);
    }
  }
  return pairs;
}

TEST(ClosePairs, AreThoseOfTheDefinitionOnceEach) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const Index count = random.index(150);
    const double size = std::pow(10.0, trial % 7 - 3);
    Points points = size * random.in_cube(count);
    if (trial % 3 == 0) points.row(2).setZero();
    if (trial % 4 == 0) points.colwise() += Eigen::Vector3d(1e6, -1e6, 0) * size;
    if (trial % 5 == 0 && count > 10) points.leftCols(10).colwise() = points.col(10).eval();
    const double ratio = trial % 2 == 0 ? 1.0 : 300.0;  // of the largest radius to the smallest
    const Eigen::ArrayXd radii = Eigen::ArrayXd::NullaryExpr(
        count, [&] { return size * 0.3 * std::pow(ratio, -random.uniform(0, 1)); });
    EXPECT_EQ(close_pairs(points, radii), pairs_by_definition(points, radii));
  }
}

TEST(ClosePairs, AreFoundInSmallCellsWhereverAFewPointsAre) {
  testing::RandomGeometry random(3);
  Points points = random.in_cube(600);
  points.col(7).setConstant(3.4e38);
  points.col(8).setConstant(3.4e38);
  points.col(9) = Eigen::Vector3d(-1e49, 0, 0);
  const Eigen::ArrayXd radii = Eigen::ArrayXd::Constant(600, 0.01);
  EXPECT_EQ(close_pairs(points, radii), pairs_by_definition(points, radii));
  // were all the near ones in one cell, this would look at 2e9 pairs
  points = random.in_cube(60'000);
  points.col(7).setConstant(3.4e38);
  Index num_pairs = 0;
  for_each_close_pair(points, Eigen::ArrayXd::Constant(60'000, 1e-4),
                      [&](Index, Index, double) { return ++num_pairs > 0; });
  EXPECT_LT(num_pairs, 500);
}

TEST(ClosePairs, AreFoundWhereTheRadiusIsMuchSmallerThanTheExtent) {
  testing::RandomGeometry random(2);
  Points points = 1e6 * random.in_cube(400);
  for (Index i = 0; i < 200; ++i) points.col(200 + i) = points.col(i) + 1e-4 * random.unit();
  const Eigen::ArrayXd radii = Eigen::ArrayXd::Constant(400, 6e-5);
  EXPECT_EQ(close_pairs(points, radii).size(), 200u);
}

TEST(ClosePairs, OnTheBordersOfTheirCellsAreNotLost) {
  // a lattice whose neighbours are exactly at the radius
  Points points(3, 216);
  for (Index i = 0; i < 216; ++i) points.col(i) << i % 6, i / 6 % 6, i / 36;
  const Eigen::ArrayXd radii = Eigen::ArrayXd::Constant(216, 0.5);
  EXPECT_EQ(close_pairs(points, radii).size(), 3u * 5 * 36);
}

TEST(ClosePairs, EndWhereTheVisitorSaysSo) {
  int visits = 0;
  EXPECT_FALSE(for_each_close_pair(Points::Zero(3, 100), Eigen::ArrayXd::Ones(100),
                                   [&](Index, Index, double) { return ++visits < 7; }));
  EXPECT_EQ(visits, 7);
}

}  // namespace
}  // namespace gmcr::geometry
