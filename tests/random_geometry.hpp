#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <random>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::testing {

/// Seeded random geometry for tests.
class RandomGeometry {
 public:
  explicit RandomGeometry(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  double normal() { return std::normal_distribution<double>()(generator_); }
  Index index(Index count) {
    return std::uniform_int_distribution<Index>(0, count - 1)(generator_);
  }

  Eigen::Vector3d unit() { return Eigen::Vector3d(normal(), normal(), normal()).normalized(); }
  Eigen::Matrix3d rotation() {
    return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().matrix();
  }
  /// Uniform in the ball.
  Eigen::Vector3d in_ball(double radius) { return radius * std::cbrt(uniform(0, 1)) * unit(); }
  /// Uniform in the cube [-half, half]^3.
  Points in_cube(Index count, double half = 0.5) {
    return Points::NullaryExpr(3, count, [&](Index, Index) { return uniform(-half, half); });
  }
  Similarity similarity(double min_scale, double max_scale, double max_translation) {
    return {uniform(min_scale, max_scale), rotation(),
            Eigen::Vector3d(uniform(-max_translation, max_translation),
                            uniform(-max_translation, max_translation),
                            uniform(-max_translation, max_translation))};
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace gmcr::testing
