#include "geometry/plane_normal.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/elementary.hpp"

namespace gmcr::geometry {
namespace {

/// Share of the spread along the longest axis below which the middle one counts as none.
constexpr double kLineTolerance = 1e-6;

/// Of the columns of a singular symmetric matrix, and of their cross products, the longest.
struct Longest {
  Eigen::Vector3d column, cross;
};

Longest longest_of(const Eigen::Matrix3d& m) {
  Longest longest{m.col(0), m.col(1).cross(m.col(2))};
  const auto replace = [](Eigen::Vector3d& old, const Eigen::Vector3d& other) {
    if (other.squaredNorm() > old.squaredNorm()) old = other;
  };
  for (int i = 1; i < 3; ++i) {
    replace(longest.column, m.col(i));
    replace(longest.cross, m.col((i + 1) % 3).cross(m.col((i + 2) % 3)));
  }
  return longest;
}

}  // namespace

Eigen::Vector3d plane_normal(const Eigen::Matrix3d& covariance) {
  const double mean = covariance.trace() / 3;
  Eigen::Matrix3d deviation = covariance - mean * Eigen::Matrix3d::Identity();
  const double size = deviation.cwiseAbs().maxCoeff();
  if (!(mean > 0)) return Eigen::Vector3d::Zero();
  if (size > 0) deviation /= size;
  // its eigenvalues, which sum up to 0: 2 p cos(angle + k 2 pi / 3)
  const double p = std::sqrt(deviation.squaredNorm() / 6);
  const double cosine = deviation.determinant() / 2, square = p * p * p;
  const double sine = std::sqrt(std::max(0.0, (square - cosine) * (square + cosine)));
  const double angle = elementary::atan2(sine, cosine) / 3;
  const double across = std::numbers::sqrt3 * elementary::sin(angle),
               along = elementary::cos(angle);
  const double least = -p * (along + across), middle = p * (across - along), most = 2 * p * along;
  if (!(mean + size * middle > kLineTolerance * (mean + size * most))) {
    return Eigen::Vector3d::Zero();
  }
  deviation.diagonal().array() -= least;
  const Longest longest = longest_of(deviation);
  // where the two least spreads are alike, any direction across the longest axis
  constexpr double kAlike = 1e-14;
  if (longest.cross.norm() > kAlike) return longest.cross.normalized();
  if (longest.column.norm() > kAlike) return longest.column.unitOrthogonal();
  return Eigen::Vector3d::UnitX();
}

}  // namespace gmcr::geometry
