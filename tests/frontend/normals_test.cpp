#include "frontend/features/normals.hpp"

#include <gtest/gtest.h>

#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::random_points;
using testing::some_motion;

Points normals_of(const Points& points, double radius, int num_threads = 0) {
  return estimate_normals(points, find_neighbourhoods(points, radius, num_threads), radius,
                          num_threads);
}

TEST(Normals, OfAPlaneArePerpendicularToIt) {
  Points points = random_points(400, 1);
  points.row(2).setZero();
  const Similarity motion = some_motion();
  const Points normals = normals_of(motion.apply(points), 0.4);
  const Eigen::Vector3d expected = motion.rotation.col(2);
  for (const auto& normal : normals.colwise()) {
    EXPECT_NEAR(std::abs(normal.dot(expected)), 1, 1e-9);
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
  }
}

TEST(Normals, UseOnlyNeighboursWithinTheirRadius) {
  // a step: neighbours past the radius would tilt the normal
  Points points = random_points(2000, 2);
  points.row(2) = 0.4 * (points.row(0).array() > 0.5).cast<double>();
  const Neighbourhoods wide = find_neighbourhoods(points, 1.0, 0);
  const Points narrow_normals = estimate_normals(points, wide, 0.2, 0);
  const Points wide_normals = estimate_normals(points, wide, 1.0, 0);
  double narrow_worst = 1;
  double wide_worst = 1;
  for (Index i = 0; i < points.cols(); ++i) {
    if (points(0, i) > 0.25) continue;
    narrow_worst = std::min(narrow_worst, std::abs(narrow_normals(2, i)));
    wide_worst = std::min(wide_worst, std::abs(wide_normals(2, i)));
  }
  EXPECT_GT(narrow_worst, 1 - 1e-9);
  EXPECT_LT(wide_worst, 0.99);
}

TEST(Normals, OfALineOrOfTooFewPointsAreZero) {
  Points line = Points::Zero(3, 20);
  line.row(0).setLinSpaced(0, 1);
  EXPECT_TRUE(normals_of(line, 0.2).isZero(0));
  EXPECT_TRUE(normals_of(random_points(2, 1), 10).isZero(0));
  EXPECT_TRUE(normals_of(Points::Zero(3, 30), 1).isZero(0));
}

TEST(Normals, TurnTowardTheViewpoint) {
  const Points points = bumpy_sphere(1000, 3);
  const Eigen::Vector3d viewpoint(5, 1, -2);
  const Points normals = orient_toward(points, normals_of(points, 0.3), viewpoint);
  for (Index i = 0; i < points.cols(); ++i) {
    EXPECT_GE(normals.col(i).dot(viewpoint - points.col(i)), 0);
  }
}

TEST(Normals, OfASphereTurnOutward) {
  Points points = bumpy_sphere(2000, 3);
  points.colwise().normalize();
  points.colwise() += Eigen::Vector3d(10, 20, 30);
  const Points normals = orient_outward(points, normals_of(points, 0.3));
  for (Index i = 0; i < points.cols(); ++i) {
    EXPECT_GT(normals.col(i).dot(points.col(i) - Eigen::Vector3d(10, 20, 30)), 0.9);
  }
}

TEST(Normals, DoNotDependOnTheNumberOfThreads) {
  const Points points = bumpy_sphere(2000, 4);
  const Points one = normals_of(points, 0.2, 1);
  EXPECT_EQ(normals_of(points, 0.2, 3), one);
}

}  // namespace
}  // namespace gmcr::frontend
