#include "gmcr/points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <list>
#include <vector>

namespace gmcr {
namespace {

struct PointXyzi {  // as PCL's
  float x, y, z, padding, intensity;
};

struct Cloud {  // as Open3D's
  std::vector<Eigen::Vector3d> points_;
};

const Points kTwo = (Points(3, 2) << 1, 4, 2, 5, 3, 6).finished();

TEST(PointsFrom, TakesStructsWithXAndYAndZ) {
  EXPECT_EQ(points_from(std::vector<PointXyzi>{{1, 2, 3, 0, 9}, {4, 5, 6, 0, 9}}), kTwo);
}

TEST(PointsFrom, TakesThreeNumbersByIndexOfAnyRange) {
  EXPECT_EQ(points_from(std::vector<std::array<float, 3>>{{1, 2, 3}, {4, 5, 6}}), kTwo);
  EXPECT_EQ(points_from(std::list<Eigen::Vector3f>{{1, 2, 3}, {4, 5, 6}}), kTwo);
  EXPECT_EQ(points_from(Cloud{{{1, 2, 3}, {4, 5, 6}}}), kTwo);
  EXPECT_EQ(points_from(std::vector<PointXyzi>{}).cols(), 0);
}

TEST(PointsFrom, TakesBuffersWithAStride) {
  const float packed[] = {1, 2, 3, 4, 5, 6};
  const double padded[] = {1, 2, 3, 9, 4, 5, 6, 9};
  EXPECT_EQ(points_from_strided<float>(packed, 2), kTwo);
  EXPECT_EQ(points_from_strided<double>(padded, 2, 4 * sizeof(double)), kTwo);
  EXPECT_EQ(points_from_strided<float>(nullptr, 0).cols(), 0);
}

TEST(FinitePoints, AreKeptInOrder) {
  Points points(3, 4);
  points << kTwo, kTwo;
  points(1, 1) = std::numeric_limits<double>::quiet_NaN();
  points(2, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(finite_points(points), kTwo);
}

}  // namespace
}  // namespace gmcr
