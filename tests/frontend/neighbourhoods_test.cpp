#include "frontend/points/neighbourhoods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using testing::random_points;

std::vector<std::int32_t> brute_force(const Points& points, double radius, Index i) {
  std::vector<std::int32_t> neighbours;
  for (Index j = 0; j < points.cols(); ++j) {
    if (j == i || (points.col(j) - points.col(i)).squaredNorm() >= radius * radius) continue;
    neighbours.push_back(static_cast<std::int32_t>(j));
  }
  return neighbours;
}

std::vector<std::int32_t> indices_of(const Neighbourhoods& found, Index i) {
  const auto indices = found.indices_of(i);
  return {indices.begin(), indices.end()};
}

TEST(Neighbourhoods, AgreeWithBruteForce) {
  const Points points = random_points(700, 11);
  const Neighbourhoods found = find_neighbourhoods(points, 0.4, 0);
  for (Index i = 0; i < points.cols(); ++i) {
    const auto indices = found.indices_of(i);
    std::vector<std::int32_t> sorted(indices.begin(), indices.end());
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, brute_force(points, 0.4, i));
    for (std::size_t k = 0; k < indices.size(); ++k) {
      EXPECT_NEAR(found.squared_distances_of(i)[k],
                  (points.col(indices[k]) - points.col(i)).squaredNorm(), 1e-14);
    }
  }
}

TEST(Neighbourhoods, OfDuplicatesHoldTheOthers) {
  const Points points = Points::Constant(3, 40, 0.5);
  const Neighbourhoods found = find_neighbourhoods(points, 0.1, 1);
  for (Index i = 0; i < 40; ++i) EXPECT_EQ(found.indices_of(i).size(), 39u);
}

TEST(Neighbourhoods, OfFewPointsAreRight) {
  find_neighbourhoods(Points(3, 0), 1, 1);
  EXPECT_TRUE(find_neighbourhoods(Points::Zero(3, 1), 1, 1).indices_of(0).empty());
  const Neighbourhoods two = find_neighbourhoods(Points::Zero(3, 2), 1, 1);
  EXPECT_EQ(indices_of(two, 0), std::vector<std::int32_t>{1});
  EXPECT_EQ(indices_of(two, 1), std::vector<std::int32_t>{0});
}

TEST(Neighbourhoods, LeaveOutPointsAtTheRadius) {
  Points points = Points::Zero(3, 3);
  points(0, 1) = 1;
  points(0, 2) = -0.999;
  EXPECT_EQ(indices_of(find_neighbourhoods(points, 1, 1), 0), std::vector<std::int32_t>{2});
}

TEST(Neighbourhoods, HoldWithPointsFarAway) {
  Points points = random_points(300, 13);
  points.col(7) = Eigen::Vector3d(1e9, -1e9, 1e300);
  points.col(8) = points.col(7);
  const Neighbourhoods found = find_neighbourhoods(points, 0.4, 2);
  EXPECT_EQ(indices_of(found, 7), std::vector<std::int32_t>{8});
  for (Index i = 20; i < 60; ++i) {
    std::vector<std::int32_t> sorted = indices_of(found, i);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, brute_force(points, 0.4, i));
  }
}

TEST(Neighbourhoods, DoNotDependOnTheNumberOfThreads) {
  const Points points = random_points(3000, 12);
  const Neighbourhoods one = find_neighbourhoods(points, 0.2, 1);
  for (const int threads : {2, 3, 8}) {
    const Neighbourhoods many = find_neighbourhoods(points, 0.2, threads);
    for (Index i = 0; i < points.cols(); ++i) {
      ASSERT_EQ(indices_of(many, i), indices_of(one, i));
      const auto a = many.squared_distances_of(i), b = one.squared_distances_of(i);
      ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
  }
}

}  // namespace
}  // namespace gmcr::frontend
