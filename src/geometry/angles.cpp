#include "geometry/angles.hpp"

#include <cmath>

#include "geometry/elementary.hpp"

namespace gmcr::geometry {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a.stableNormalized(), v = b.stableNormalized();
  return elementary::atan2(u.cross(v).norm(), u.dot(v));
}

double rotation_angle(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return 2 * elementary::atan2(q.vec().norm(), std::abs(q.w()));
}

Eigen::Matrix3d exact_rotation(const Eigen::Matrix3d& rotation) {
  return Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
}

Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle) {
  const Eigen::Vector3d sines = elementary::sin(angle) * axis;
  const double cosine = elementary::cos(angle);
  Eigen::Matrix3d cross;
  cross << 0, -sines.z(), sines.y(), sines.z(), 0, -sines.x(), -sines.y(), sines.x(), 0;
  return cosine * Eigen::Matrix3d::Identity() + (1 - cosine) * axis * axis.transpose() + cross;
}

AxisAngle axis_angle(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  const double sine = q.vec().norm();
  if (sine == 0) return {Eigen::Vector3d::UnitX(), 0};
  return {q.vec() / (q.w() < 0 ? -sine : sine), 2 * elementary::atan2(sine, std::abs(q.w()))};
}

Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.stableNormalized(), b = to.stableNormalized(), cross = a.cross(b);
  const double cosine = b.dot(a), sine = cross.norm();
  constexpr double kOpposite = -0.5;  // below, 1 + cosine would lose digits
  if (cosine < kOpposite) {
    constexpr double kSeen = 1e-6;
    const Eigen::Vector3d axis = sine > kSeen ? cross / sine : a.unitOrthogonal();
    const Eigen::Quaterniond half_turn(0, axis.x(), axis.y(), axis.z());
    return (turn_between(half_turn * a, b) * half_turn).normalized();
  }
  const double twice = std::sqrt((1 + cosine) * 2);
  Eigen::Quaterniond turn;
  turn.vec() = cross / twice;
  turn.w() = twice / 2;
  return turn.normalized();
}

double tilt(const GravityPrior& gravity, const Eigen::Matrix3d& rotation) {
  return angle_between(rotation * gravity.source.stableNormalized(), gravity.target);
}

double turn_from(const InitialPose& initial, const Eigen::Matrix3d& rotation) {
  return rotation_angle(rotation * exact_rotation(initial.target_from_source.rotation).transpose());
}

}  // namespace gmcr::geometry
