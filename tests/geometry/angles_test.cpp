#include "geometry/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "random_geometry.hpp"

namespace gmcr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Angles, TurnBetweenIsARotationThatTakesOneToTheOther) {
  testing::RandomGeometry random(11);
  for (int i = 0; i < 3000; ++i) {
    const Vector3d from = random.unit();
    // nearly equal, nearly opposite, nearly at right angles, and all between
    const Vector3d beside = std::pow(10, random.uniform(-18, 1)) * random.unit();
    const Vector3d near_to[] = {from, -from, from.unitOrthogonal()};
    const Vector3d to = (near_to[i % 3] + beside).normalized();
    const Matrix3d turn = geometry::turn_between(3 * from, to / 7).toRotationMatrix();
    ASSERT_LT((turn * turn.transpose() - Matrix3d::Identity()).norm(), 1e-14) << beside.norm();
    ASSERT_LT((turn * from - to).norm(), 1e-14) << beside.norm();
    ASSERT_NEAR(geometry::rotation_angle(turn), geometry::angle_between(from, to), 1e-5);
  }
}

TEST(Angles, TurnAboutAnAxisHasThatAxisAndAngle) {
  testing::RandomGeometry random(12);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d axis = random.unit();
    const double angle = random.uniform(0.01, 3.13);
    const Matrix3d turn = geometry::turn_about(axis, angle);
    ASSERT_LT((turn - Eigen::AngleAxisd(angle, axis).toRotationMatrix()).norm(), 1e-14);
    const auto [found_axis, found_angle] = geometry::axis_angle(turn);
    ASSERT_LT((found_axis - axis).norm(), 1e-12);
    ASSERT_NEAR(found_angle, angle, 1e-13);
  }
  EXPECT_EQ(geometry::axis_angle(Matrix3d::Identity()).angle, 0);
}

}  // namespace
}  // namespace gmcr
