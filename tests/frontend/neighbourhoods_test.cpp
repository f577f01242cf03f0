#include "frontend/neighbourhoods.hpp"

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
  EXPECT_EQ(find_neighbourhoods(Points(3, 0), 1, 1).offsets.size(), 1u);
  EXPECT_TRUE(find_neighbourhoods(Points::Zero(3, 1), 1, 1).indices.empty());
  EXPECT_EQ(find_neighbourhoods(Points::Zero(3, 2), 1, 1).indices,
            (std::vector<std::int32_t>{1, 0}));
}

TEST(Neighbourhoods, DoNotDependOnTheNumberOfThreads) {
  const Points points = random_points(3000, 12);
  const Neighbourhoods one = find_neighbourhoods(points, 0.2, 1);
  for (const int threads : {2, 3, 8}) {
    const Neighbourhoods many = find_neighbourhoods(points, 0.2, threads);
    EXPECT_EQ(many.offsets, one.offsets);
    EXPECT_EQ(many.indices, one.indices);
    EXPECT_EQ(many.squared_distances, one.squared_distances);
  }
}

}  // namespace
}  // namespace gmcr::frontend
