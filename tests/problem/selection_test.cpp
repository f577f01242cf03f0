#include "problem/selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

TEST(StratifiedSelection, TakesOneOfEachPart) {
  for (const auto& [n, count] : {std::pair<Index, Index>{100, 7}, {64, 64}, {1000, 333}, {5, 1}}) {
    const std::vector<Index> selected = stratified_selection(n, count);
    ASSERT_EQ(static_cast<Index>(selected.size()), count);
    for (Index k = 0; k < count; ++k) {
      EXPECT_GE(selected[static_cast<std::size_t>(k)], k * n / count);
      EXPECT_LT(selected[static_cast<std::size_t>(k)], (k + 1) * n / count);
    }
  }
}

TEST(StratifiedSelection, OfFewIsAllOfThem) {
  EXPECT_EQ(stratified_selection(3, 10), (std::vector<Index>{0, 1, 2}));
  EXPECT_TRUE(stratified_selection(0, 10).empty());
}

TEST(StratifiedSelection, FollowsNoPattern) {
  // of rows of four, of which the last is wrong, as in an organised cloud, a quarter is wrong
  const std::vector<Index> selected = stratified_selection(40'000, 1000);
  const auto wrong =
      std::count_if(selected.begin(), selected.end(), [](Index i) { return i % 4 == 3; });
  EXPECT_NEAR(static_cast<double>(wrong), 250, 60);
}

TEST(Median, IsTheMiddleOneOrTheUpperOfTwo) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({5, 1, 3}), 3);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
}

TEST(MiddleOf, ManyPointsIsAmongMostOfThemWhateverTheOthers) {
  testing::RandomGeometry random(1);
  Points points = random.in_cube(20'000);
  points.rightCols(8000).setConstant(1e38);
  EXPECT_LT(middle_of(points).cwiseAbs().maxCoeff(), 0.5);
}

TEST(MedianPoint, OfNoPointsIsTheOrigin) {
  EXPECT_EQ(median_point(Points(3, 0)), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace gmcr::problem
