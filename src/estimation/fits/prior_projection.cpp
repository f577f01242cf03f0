#include "estimation/fits/prior_projection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimation/closed_forms/rotation.hpp"
#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::estimation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using geometry::turn_about;

/// Unit axis of the least rotation from one unit vector to another.
Vector3d axis_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d axis = from.cross(to);
  return axis.norm() > 1e-9 ? axis.normalized() : from.unitOrthogonal();
}

/// Least rotation that maps one unit vector onto another.
Matrix3d least_turn(const Vector3d& from, const Vector3d& to) {
  const Matrix3d first = turn_about(axis_between(from, to), geometry::angle_between(from, to));
  // the axis of nearly opposite vectors is inexact: what is left is a small turn
  const Vector3d reached = (first * from).normalized(), axis = reached.cross(to);
  if (axis.norm() == 0) return first;
  return turn_about(axis.normalized(), elementary::asin(std::min(1.0, axis.norm()))) * first;
}

/// The unit vector nearest to `direction` at most `angle` from `centre`.
Vector3d into_cap(const Vector3d& direction, const Vector3d& centre, double angle) {
  if (geometry::angle_between(centre, direction) <= angle) return direction;
  return turn_about(axis_between(centre, direction), angle) * centre;
}

/// The place nearest to `direction` that lies in two caps on the sphere.
std::optional<Vector3d> into_both_caps(const Vector3d& direction, const Vector3d& centre,
                                       double angle, const Vector3d& other, double other_angle) {
  constexpr double kRounding = geometry::kAngleSlack / 2;
  const auto in_both = [&](const Vector3d& place) {
    return geometry::angle_between(place, centre) <= angle + kRounding &&
           geometry::angle_between(place, other) <= other_angle + kRounding;
  };
  for (const Vector3d& place :
       {into_cap(direction, centre, angle), into_cap(direction, other, other_angle)}) {
    if (in_both(place)) return place;
  }
  // a corner: at both angles, in the frame of the centre, the other centre and their normal
  const double between = geometry::angle_between(centre, other);
  const Vector3d normal = axis_between(centre, other), across = normal.cross(centre);
  const double x = elementary::cos(angle);
  const double y =
      (elementary::cos(other_angle) - elementary::cos(between) * x) / elementary::sin(between);
  const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  const Vector3d corner =
      (x * centre + y * across + (direction.dot(normal) < 0 ? -z : z) * normal).normalized();
  if (in_both(corner)) return corner;
  // where the caps only touch, z is all rounding
  const Vector3d touching = turn_about(normal, angle) * centre;
  return in_both(touching) ? std::optional(touching) : std::nullopt;
}

/// Angle about a unit axis by which to turn `rotation` so that tr(R^T covariance) is largest; 0
/// where all are as good.
double best_yaw(const Matrix3d& rotation, const Vector3d& axis, const Matrix3d& covariance) {
  const Matrix3d m = covariance * rotation.transpose();
  const Vector3d odd(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
  const double cosine = m.trace() - axis.dot(m * axis), sine = axis.dot(odd);
  constexpr double kUndetermined = 1e-12;
  if (std::sqrt(cosine * cosine + sine * sine) <= kUndetermined * m.norm()) return 0;
  return elementary::atan2(sine, cosine);
}

Matrix3d limit_turn(const InitialPose& initial, const Matrix3d& rotation) {
  const Matrix3d known = geometry::exact_rotation(initial.target_from_source.rotation);
  const auto [axis, angle] = geometry::axis_angle(rotation * known.transpose());
  return turn_about(axis, std::min(angle, initial.max_rotation)) * known;
}

/// Largest turn about the image of gravity that keeps a turn of `least` about an axis across it
/// within `limit`: cos(limit / 2) = cos(least / 2) cos(turn / 2).
double largest_yaw(double least, double limit) {
  if (limit >= std::numbers::pi) return std::numbers::pi;
  const double squared_sine = elementary::sin((limit + least) / 2) *
                              elementary::sin((limit - least) / 2) /
                              (elementary::cos(least / 2) * elementary::cos(least / 2));
  return 2 * elementary::asin(std::sqrt(std::clamp(squared_sine, 0.0, 1.0)));
}

/// The rotation that maps gravity to `image` and fits best, near `start`.
Matrix3d best_with_image(const Priors& priors, const Vector3d& up, const Vector3d& image,
                         const Matrix3d& start, const Matrix3d& covariance) {
  if (!priors.initial_pose) {
    const Matrix3d level = least_turn((start * up).normalized(), image) * start;
    return turn_about(image, best_yaw(level, image, covariance)) * level;
  }
  const Matrix3d known = geometry::exact_rotation(priors.initial_pose->target_from_source.rotation);
  const Vector3d known_image = (known * up).normalized();
  const Matrix3d level = least_turn(known_image, image) * known;
  const double limit =
      largest_yaw(geometry::angle_between(known_image, image), priors.initial_pose->max_rotation);
  return turn_about(image, std::clamp(best_yaw(level, image, covariance), -limit, limit)) * level;
}

bool admit_rotation(const Priors& priors, const Matrix3d& rotation) {
  if (priors.gravity && geometry::tilt(*priors.gravity, rotation) >
                            priors.gravity->max_tilt + geometry::kAngleSlack) {
    return false;
  }
  return !priors.initial_pose || geometry::turn_from(*priors.initial_pose, rotation) <=
                                     priors.initial_pose->max_rotation + geometry::kAngleSlack;
}

/// The argmax over SO(3) of tr(R^T H). Where it is not unique, the one nearest to what is known.
Matrix3d unconstrained_rotation(const Matrix3d& covariance, const Priors& priors) {
  if (const auto unique = rotation_from_covariance(covariance)) return *unique;
  Matrix3d known = Matrix3d::Identity();
  if (priors.initial_pose)
    known = geometry::exact_rotation(priors.initial_pose->target_from_source.rotation);
  if (priors.gravity) {
    known = best_with_image(priors, priors.gravity->source.stableNormalized(),
                            priors.gravity->target.stableNormalized(), known, covariance);
  }
  return least_rotation(covariance * known.transpose()) * known;
}

/// The point of a ball nearest to `translation`.
Vector3d into_ball(const Vector3d& translation, const Vector3d& centre, double radius) {
  const Vector3d offset = translation - centre;
  const double distance = offset.norm();
  return distance <= radius ? translation : Vector3d(centre + offset * (radius / distance));
}

}  // namespace

std::optional<Matrix3d> admitted_rotation(const Matrix3d& covariance, const Priors& priors) {
  const Matrix3d best = unconstrained_rotation(covariance, priors);
  if (admit_rotation(priors, best)) return best;
  if (priors.initial_pose) {
    const Matrix3d limited = limit_turn(*priors.initial_pose, best);
    if (admit_rotation(priors, limited)) return limited;
  }
  if (!priors.gravity) return std::nullopt;
  const Vector3d source_up = priors.gravity->source.stableNormalized();
  const Vector3d target_up = priors.gravity->target.stableNormalized();
  const Vector3d image = (best * source_up).normalized();
  const double max_tilt = priors.gravity->max_tilt;
  const std::optional<Vector3d> nearest =
      priors.initial_pose
          ? into_both_caps(
                image, target_up, max_tilt,
                geometry::exact_rotation(priors.initial_pose->target_from_source.rotation) *
                    source_up,
                priors.initial_pose->max_rotation)
          : into_cap(image, target_up, max_tilt);
  if (!nearest) return std::nullopt;
  const Matrix3d rotation = best_with_image(priors, source_up, *nearest, best, covariance);
  if (!admit_rotation(priors, rotation)) return std::nullopt;
  return rotation;
}

std::optional<Vector3d> admitted_translation(const Vector3d& translation, const Priors& priors) {
  const double radius = priors.max_translation;
  const Vector3d in_first =
      std::isfinite(radius) ? into_ball(translation, Vector3d::Zero(), radius) : translation;
  if (!priors.initial_pose || !std::isfinite(priors.initial_pose->max_translation)) return in_first;
  const Vector3d& centre = priors.initial_pose->target_from_source.translation;
  const double other_radius = priors.initial_pose->max_translation;
  const double rounding = 1e-13 * (centre.norm() + other_radius);
  if ((in_first - centre).norm() <= other_radius + rounding) return in_first;
  const Vector3d in_second = into_ball(translation, centre, other_radius);
  if (!std::isfinite(radius) || in_second.norm() <= radius + rounding) return in_second;
  // where the spheres meet
  const double distance = centre.norm();
  if (distance > radius + other_radius) return std::nullopt;
  const Vector3d axis = centre / distance;
  const double along =
      distance / 2 + (radius - other_radius) * (radius + other_radius) / (2 * distance);
  const Vector3d off_axis = translation - axis * axis.dot(translation);
  const Vector3d across = off_axis.norm() > 0 ? off_axis.normalized() : axis.unitOrthogonal();
  return along * axis + std::sqrt(std::max(0.0, (radius - along) * (radius + along))) * across;
}

std::optional<Similarity> admitted_pose(const Similarity& pose, const Priors& priors) {
  const auto translation = admitted_translation(pose.translation, priors);
  if (!translation) return std::nullopt;
  Similarity admitted = pose;
  admitted.translation = *translation;
  if (!priors.admit(admitted)) return std::nullopt;
  return admitted;
}

}  // namespace gmcr::estimation
