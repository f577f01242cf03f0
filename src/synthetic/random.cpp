#include "synthetic/random.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numeric>

namespace gmcr::synthetic {

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

double Random::uniform(double low, double high) { return low + (high - low) * uniform(); }

Index Random::index(Index count) {
  const auto range = static_cast<std::uint64_t>(count);
  // The last, incomplete block of `range` values would favour small indices.
  const std::uint64_t limit = std::numeric_limits<std::uint64_t>::max() / range * range;
  std::uint64_t value = engine_();
  while (value >= limit) value = engine_();
  return static_cast<Index>(value % range);
}

double Random::normal() {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform();
  return sum;
}

Eigen::Vector3d Random::in_cube(double half_edge) {
  Eigen::Vector3d point;
  for (double& coordinate : point) coordinate = uniform(-half_edge, half_edge);
  return point;
}

Eigen::Vector3d Random::in_ball(double radius) {
  Eigen::Vector3d point = in_cube(1);
  while (point.squaredNorm() > 1) point = in_cube(1);
  return radius * point;
}

Eigen::Vector3d Random::unit_vector() {
  Eigen::Vector3d point = in_ball(1);
  while (point.squaredNorm() < 1e-6) point = in_ball(1);
  return point / point.norm();
}

Eigen::Matrix3d Random::rotation() {
  // A uniform direction in four dimensions is a uniform rotation.
  Eigen::Vector4d q;
  do {
    for (double& coordinate : q) coordinate = uniform(-1, 1);
  } while (q.squaredNorm() > 1 || q.squaredNorm() < 1e-6);
  q /= q.norm();
  return Eigen::Quaterniond(q(0), q(1), q(2), q(3)).toRotationMatrix();
}

std::vector<Index> Random::sample(Index count, Index total) {
  std::vector<Index> indices(static_cast<std::size_t>(total));
  std::iota(indices.begin(), indices.end(), Index{0});
  for (Index i = 0; i < count; ++i) {
    std::swap(indices[static_cast<std::size_t>(i)],
              indices[static_cast<std::size_t>(i + index(total - i))]);
  }
  indices.resize(static_cast<std::size_t>(count));
  return indices;
}

}  // namespace gmcr::synthetic
