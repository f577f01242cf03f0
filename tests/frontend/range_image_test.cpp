#include "frontend/points/range_image.hpp"

#include <gtest/gtest.h>

#include "random_geometry.hpp"

namespace gmcr::frontend {
namespace {

const Eigen::Vector3d kOrigin = Eigen::Vector3d::Zero();

/// Points of a sphere of radius 1 at `centre`, or of the side of it that faces the origin.
Points sphere(const Eigen::Vector3d& centre, Index count, bool facing_only) {
  testing::RandomGeometry random(7);
  const double silhouette = 1 / centre.norm();  // as a cosine
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    Eigen::Vector3d outward = random.unit();
    while (facing_only && -outward.dot(centre.normalized()) < silhouette) outward = random.unit();
    points.col(i) = centre + outward;
  }
  return points;
}

TEST(RangeImage, TellsAViewFromAWholeObjectHoweverFarItIs) {
  for (const double distance : {3.0, 30.0, 3000.0}) {
    const Eigen::Vector3d centre(0.1 * distance, 0, distance);
    EXPECT_TRUE(RangeImage(sphere(centre, 20000, true), kOrigin).is_view()) << distance;
    EXPECT_FALSE(RangeImage(sphere(centre, 20000, false), kOrigin).is_view()) << distance;
    EXPECT_TRUE(view_from(centre, sphere(centre, 20000, false)) != nullptr) << distance;
  }
}

TEST(RangeImage, OfFewPointsOrOfOnePlaceIsNoView) {
  EXPECT_FALSE(RangeImage(sphere({0, 0, 9}, 500, true), kOrigin).is_view());
  EXPECT_FALSE(RangeImage(Points(3, 0), kOrigin).is_view());
  EXPECT_FALSE(RangeImage(Points::Zero(3, 100), kOrigin).is_view());
  EXPECT_FALSE(RangeImage(Points::Zero(3, 100), kOrigin).sees_through({1, 0, 0}, 0.1));
}

TEST(RangeImage, SeesThroughWhatLiesBeforeItsPointsOnly) {
  const Eigen::Vector3d centre(40, -30, 1200);  // also far from the origin of the coordinates
  for (const bool is_all_around : {false, true}) {
    const Eigen::Vector3d viewpoint = is_all_around ? centre : kOrigin;
    const RangeImage image(sphere(centre, 20000, !is_all_around), viewpoint);
    ASSERT_TRUE(image.is_view());
    testing::RandomGeometry random(3);
    int num_seen = 0;  // some rays end between the points
    for (int k = 0; k < 200; ++k) {
      const Eigen::Vector3d outward =
          is_all_around ? random.unit() : (-centre.normalized() + 0.3 * random.unit()).normalized();
      const Eigen::Vector3d ray = centre + outward - viewpoint;
      const Eigen::Vector3d towards = ray.normalized();
      EXPECT_FALSE(image.sees_through(ray, 0.1));
      EXPECT_FALSE(image.sees_through(ray + 0.5 * towards, 0.1));  // behind: hidden
      EXPECT_FALSE(image.sees_through(ray - 0.05 * towards, 0.1));
      num_seen += image.sees_through(ray - 0.5 * towards, 0.1);
    }
    EXPECT_GT(num_seen, 180);
    if (!is_all_around) {
      EXPECT_FALSE(image.sees_through({0, 100, 0}, 0.1));   // aside
      EXPECT_FALSE(image.sees_through({0, 0, -100}, 0.1));  // at the back
    }
  }
}

}  // namespace
}  // namespace gmcr::frontend
