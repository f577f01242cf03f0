#include "geometry/angles.hpp"

#include <cmath>

namespace gmcr::geometry {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a.stableNormalized(), v = b.stableNormalized();
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

double rotation_angle(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return 2 * std::atan2(q.vec().norm(), std::abs(q.w()));
}

Eigen::Matrix3d exact_rotation(const Eigen::Matrix3d& rotation) {
  return Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
}

Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

double tilt(const GravityPrior& gravity, const Eigen::Matrix3d& rotation) {
  return angle_between(rotation * gravity.source.stableNormalized(), gravity.target);
}

double turn_from(const InitialPose& initial, const Eigen::Matrix3d& rotation) {
  return rotation_angle(rotation * exact_rotation(initial.target_from_source.rotation).transpose());
}

}  // namespace gmcr::geometry
