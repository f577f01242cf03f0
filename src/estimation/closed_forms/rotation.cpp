#include "estimation/closed_forms/rotation.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "estimation/closed_forms/singular_pairs.hpp"
#include "geometry/angles.hpp"

namespace gmcr::estimation {

std::optional<Eigen::Matrix3d> rotation_from_covariance(const Eigen::Matrix3d& covariance) {
  constexpr double kRankTolerance = 1e-12;
  const SingularPairs pairs = leading_singular_pairs(covariance);
  if (!(pairs.values[1] > kRankTolerance * pairs.values[0])) return std::nullopt;
  // the third axes made right-handed: what the reflection guard does with the least singular value
  const Eigen::Vector3d third_left = pairs.left.col(0).cross(pairs.left.col(1));
  const Eigen::Vector3d third_right = pairs.right.col(0).cross(pairs.right.col(1));
  // R = U diag(1, 1, det(U V^T)) V^T of H = U S V^T
  return pairs.left * pairs.right.transpose() + third_left * third_right.transpose();
}

Eigen::Matrix3d least_rotation(const Eigen::Matrix3d& covariance) {
  const SingularPairs pairs = leading_singular_pairs(covariance);
  if (!(pairs.values[0] > 0)) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d from = pairs.right.col(0), to = pairs.left.col(0);
  return geometry::turn_between(from, to).toRotationMatrix();
}

std::optional<Eigen::Matrix3d> estimate_rotation(const PointsRef& a, const PointsRef& b) {
  if (a.cols() != b.cols()) throw std::invalid_argument("b: number of columns differs from a");
  if (a.cols() < 2) return std::nullopt;
  // argmin_R sum_k |b_k - R a_k|^2 = argmax_R tr(R^T H), H = sum_k b_k a_k^T
  return rotation_from_covariance(b * a.transpose());
}

}  // namespace gmcr::estimation
