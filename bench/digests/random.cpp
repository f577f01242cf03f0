#include "digests/random.hpp"

#include <Eigen/Geometry>

namespace gmcr::bench {

double Random::uniform(double low, double high) {
  const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

Index Random::index(Index size) {
  return static_cast<Index>(engine_() % static_cast<std::uint64_t>(size));
}

Eigen::Vector3d Random::point(double low, double high) {
  Eigen::Vector3d point;
  for (double& coordinate : point) coordinate = uniform(low, high);
  return point;
}

Points Random::points(Index size, double low, double high) {
  Points points(3, size);
  for (Index i = 0; i < size; ++i) points.col(i) = point(low, high);
  return points;
}

Eigen::Matrix3d Random::rotation() {
  Eigen::Quaterniond turn;
  for (double& coefficient : turn.coeffs()) coefficient = uniform(-1, 1);  // one after the other
  return turn.normalized().toRotationMatrix();
}

}  // namespace gmcr::bench
