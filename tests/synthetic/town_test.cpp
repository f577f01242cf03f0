#include "synthetic/town/town.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "synthetic/town/lidar.hpp"
#include "synthetic/town/ray_caster.hpp"

namespace gmcr::synthetic {
namespace {

Town small_town(std::uint64_t seed = 1) {
  TownOptions options;
  options.extent = 100;
  options.block = 50;
  options.seed = seed;
  return make_town(options);
}

/// A box of 2 x 4 x 3 m whose near face is 9 m along x, and a pole of radius 0.5 m at y = 20.
Town box_and_pole() {
  Town town;
  town.extent = 50;
  town.boxes.push_back({{10, 0}, {1, 0}, {1, 2}, 0, 3});
  town.cylinders.push_back({{0, 20}, 0.5, 0, 6});
  return town;
}

TEST(RayCaster, MeetsBoxPoleAndGroundWhereTheyAre) {
  const RayCaster caster(box_and_pole());
  const Eigen::Vector3d origin(0, 0, 2), x(1, 0, 0), y(0, 1, 0);
  EXPECT_NEAR(caster.distance(origin, x, 100), 9, 1e-12);
  EXPECT_NEAR(caster.distance(origin, y, 100), 19.5, 1e-12);
  EXPECT_NEAR(caster.distance(origin, -Eigen::Vector3d::UnitZ(), 100), 2, 1e-12);
  EXPECT_EQ(caster.distance(origin, -x, 100), 100);
  EXPECT_EQ(caster.distance(origin, x, 5), 5);
  const Eigen::Vector3d over = Eigen::Vector3d(9, 0, 1.5).normalized();  // over the box of 3 m
  EXPECT_EQ(caster.distance(origin, over, 100), 100);
  const Eigen::Vector3d beside = Eigen::Vector3d(10, 3.5, 0).normalized();
  EXPECT_EQ(caster.distance(origin, beside, 100), 100);
}

TEST(RayCaster, SeesTheNearestOfAllShapesInAnyDirection) {
  const Town town = small_town();
  const RayCaster caster(town);
  Random random(3);
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d origin(random.uniform(0, 100), 50, 1.8), ray = random.unit_vector();
    double nearest = 100;
    for (const TownBox& box : town.boxes) {  // each alone
      nearest = std::min(nearest, RayCaster({{box}, {}, {}, 100}).distance(origin, ray, 100));
    }
    for (const TownCylinder& pole : town.cylinders) {
      nearest = std::min(nearest, RayCaster({{}, {pole}, {}, 100}).distance(origin, ray, 100));
    }
    EXPECT_EQ(caster.distance(origin, ray, 100), nearest) << k;
  }
}

TEST(Town, IsTheSameForASeedAndHasOtherCarsOnAnotherDay) {
  const Town town = small_town(), again = small_town(), other = small_town(2);
  ASSERT_EQ(town.boxes.size(), again.boxes.size());
  EXPECT_EQ(town.boxes.back().centre, again.boxes.back().centre);
  EXPECT_NE(town.boxes.front().half, other.boxes.front().half);
  TownOptions options;
  options.extent = 100;
  options.block = 50;
  options.seed = 1;
  options.cars_seed = 9;
  const Town later = make_town(options);
  EXPECT_EQ(town.boxes.front().half, later.boxes.front().half);
  EXPECT_NE(town.boxes.back().centre, later.boxes.back().centre);
}

TEST(Lidar, HasItsRingsAndItsNoise) {
  const Town town = small_town();
  const RayCaster caster(town);
  Random random(1);
  const Similarity pose = sensor_at(random_place(town, random), 2, random);
  Lidar lidar = lidar_of(16);
  lidar.num_columns = 360;
  lidar.noise = 0;
  const Points exact = scan(caster, pose, lidar, 5);
  lidar.noise = 0.02;
  const Points noisy = scan(caster, pose, lidar, 5);
  ASSERT_EQ(exact.cols(), noisy.cols());
  EXPECT_GT(exact.cols(), 1000);
  EXPECT_EQ(noisy, scan(caster, pose, lidar, 5));
  for (Index i = 0; i < exact.cols(); ++i) {
    const double elevation = std::asin(exact(2, i) / exact.col(i).norm()) * 180 / M_PI;
    EXPECT_NEAR(elevation, -15 + 2 * std::round((elevation + 15) / 2), 1e-9);
    EXPECT_GE(pose.rotation.row(2).dot(exact.col(i)) + pose.translation.z(), -1e-9);
  }
  const double rms = std::sqrt((noisy - exact).colwise().squaredNorm().mean());
  EXPECT_NEAR(rms, 0.02, 0.002);
  EXPECT_THROW(lidar_of(20), std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::synthetic
