#include "geometry/plane_normal.hpp"

#include <gtest/gtest.h>

#include "random_geometry.hpp"

namespace gmcr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A covariance with these spreads along the columns of `axes`.
Matrix3d covariance_of(const Matrix3d& axes, const Vector3d& spread) {
  return axes * spread.asDiagonal() * axes.transpose();
}

TEST(PlaneNormal, IsTheAxisOfLeastSpread) {
  testing::RandomGeometry random(3);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d axes = random.rotation();
    const double size = std::pow(10, random.uniform(-100, 100));
    const double least = random.uniform(0, 0.9), middle = random.uniform(least + 0.05, 2);
    const Vector3d spread = size * Vector3d(least, middle, middle + random.uniform(0, 2));
    const Vector3d normal = geometry::plane_normal(covariance_of(axes, spread));
    ASSERT_NEAR(normal.norm(), 1, 1e-14);
    ASSERT_NEAR(std::abs(normal.dot(axes.col(0))), 1, 1e-12) << spread.transpose();
  }
}

TEST(PlaneNormal, OfAThinPlaneIsExact) {
  testing::RandomGeometry random(4);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d axes = random.rotation();
    const Vector3d spread(0, random.uniform(1e-3, 1), 1);
    const Vector3d normal = geometry::plane_normal(covariance_of(axes, spread));
    ASSERT_LT(normal.cross(axes.col(0)).norm(), 1e-9) << spread.transpose();
  }
}

TEST(PlaneNormal, OfALineOrAPlaceIsZero) {
  const Matrix3d axes = testing::RandomGeometry(5).rotation();
  EXPECT_EQ(geometry::plane_normal(covariance_of(axes, {0, 0, 1})), Vector3d(0, 0, 0));
  EXPECT_EQ(geometry::plane_normal(covariance_of(axes, {1e-9, 1e-8, 1})), Vector3d(0, 0, 0));
  EXPECT_EQ(geometry::plane_normal(Matrix3d::Zero()), Vector3d(0, 0, 0));
}

TEST(PlaneNormal, WhereTheLeastSpreadsAreAlikeIsAcrossTheLongestAxis) {
  testing::RandomGeometry random(6);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d axes = random.rotation();
    const Vector3d normal = geometry::plane_normal(covariance_of(axes, {0.5, 0.5, 1}));
    ASSERT_NEAR(normal.norm(), 1, 1e-14);
    ASSERT_NEAR(normal.dot(axes.col(2)), 0, 1e-6);
  }
  EXPECT_EQ(geometry::plane_normal(Matrix3d::Identity()).norm(), 1);
}

}  // namespace
}  // namespace gmcr
