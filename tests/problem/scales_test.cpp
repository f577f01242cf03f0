#include "problem/scales.hpp"

#include <gtest/gtest.h>

#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

TEST(DefaultScaleRange, IsCentredOnTheRatioOfTheSizes) {
  testing::RandomGeometry random(1);
  const Points source = random.in_cube(50);
  const Correspondences c = centre(source, 3 * source, Eigen::ArrayXd::Ones(50));
  const ScaleRange range = default_scale_range(c);
  EXPECT_NEAR(range.min * range.max, 9, 1e-9);
  EXPECT_LT(range.min, 0.3);
  EXPECT_GT(range.max, 30);
}

TEST(DefaultScaleRange, OfCoincidentPointsIsStillARange) {
  const ScaleRange range =
      default_scale_range({Points::Zero(3, 4), Points::Zero(3, 4), Eigen::ArrayXd::Ones(4)});
  EXPECT_GT(range.min, 0);
  EXPECT_LT(range.min, range.max);
}

}  // namespace
}  // namespace gmcr::problem
