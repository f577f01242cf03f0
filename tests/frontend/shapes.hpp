#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::testing {

/// Points in the cube [-1, 1]^3.
inline Points random_points(Index count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  return Points::NullaryExpr(3, count, [&] { return coordinate(generator); });
}

/// Points on a closed surface without symmetries, about 2 units across: a sphere with bumps.
inline Points bumpy_sphere(Index count, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    const Eigen::Vector3d d =
        Eigen::Vector3d::NullaryExpr([&] { return normal(generator); }).normalized();
    const double radius = 1 + 0.25 * std::sin(3 * d.x() + 2 * d.y()) +
                          0.2 * std::sin(5 * d.y() - 4 * d.z() + 1) +
                          0.15 * std::cos(7 * d.z() + 3 * d.x() * d.y());
    points.col(i) = radius * d;
  }
  return points;
}

/// A motion that is nothing special.
inline Similarity some_motion(double scale = 1) {
  Similarity motion;
  motion.scale = scale;
  motion.rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.translation = {3, -1, 2};
  return motion;
}

}  // namespace gmcr::testing
