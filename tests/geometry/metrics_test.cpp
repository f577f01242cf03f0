#include "gmcr/metrics.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "random_geometry.hpp"

namespace gmcr::geometry {
namespace {

Eigen::Matrix3d turn(double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 3).normalized())
      .toRotationMatrix();
}

TEST(RotationError, IsTheAngleBetweenTheRotations) {
  testing::RandomGeometry random(1);
  const Eigen::Matrix3d any = random.rotation();
  for (const double degrees : {0.0, 1e-7, 0.5, 90.0, 179.999, 180.0}) {
    EXPECT_NEAR(rotation_error_deg(any * turn(degrees), any), degrees, 1e-6 * (1e-3 + degrees));
  }
}

TEST(RotationError, IsSymmetric) {
  testing::RandomGeometry random(2);
  const Eigen::Matrix3d a = random.rotation(), b = random.rotation();
  EXPECT_NEAR(rotation_error_deg(a, b), rotation_error_deg(b, a), 1e-10);
}

TEST(TranslationError, IsTheDistance) {
  EXPECT_DOUBLE_EQ(translation_error({1, 2, 3}, {4, 6, 3}), 5);
}

TEST(ScaleError, IsRelativeToTheTruth) {
  EXPECT_DOUBLE_EQ(scale_error(3, 2), 0.5);
  EXPECT_DOUBLE_EQ(scale_error(1, 2), 0.5);
}

TEST(MeanPointError, AveragesTheDistancesOfTheImages) {
  Points points(3, 2);
  points << 0, 2, 0, 0, 0, 0;
  Similarity doubled;
  doubled.scale = 2;
  EXPECT_DOUBLE_EQ(mean_point_error(doubled, Similarity(), points), 1);
}

TEST(MeanPointError, RefusesNoPoints) {
  EXPECT_THROW(mean_point_error({}, {}, Points(3, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::geometry
