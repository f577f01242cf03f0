#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::synthetic {

/// Random numbers that are the same bits everywhere.
///
/// The engine is specified by the standard, its distributions are not, and neither are log and cos;
/// so all draws are made here, from + - * / and sqrt alone.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double uniform();

  /// Uniform in [low, high).
  double uniform(double low, double high);

  /// Uniform in {0, ..., count - 1}; count >= 1.
  Index index(Index count);

  /// Mean 0, variance 1: the sum of 12 uniform numbers, cut off at 6 sigma.
  double normal();

  /// Uniform in [-half_edge, half_edge]^3.
  Eigen::Vector3d in_cube(double half_edge);

  /// Uniform in the ball of that radius.
  Eigen::Vector3d in_ball(double radius);

  /// Uniform on the unit sphere.
  Eigen::Vector3d unit_vector();

  /// Uniform in SO(3).
  Eigen::Matrix3d rotation();

  /// `count` different indices out of {0, ..., total - 1}, in random order; 0 <= count <= total.
  std::vector<Index> sample(Index count, Index total);

 private:
  std::mt19937_64 engine_;
};

}  // namespace gmcr::synthetic
