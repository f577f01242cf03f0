#include "frontend/matching/match_priors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::frontend {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// What normals of the same place on two voxel clouds may differ by, radians.
constexpr double kNormalTolerance = kPi / 6;

ScaleRange scales_of(const Options& options) {
  if (options.scale_mode == ScaleMode::Known) return {options.scale, options.scale};
  return options.scale_range.value_or(ScaleRange{0, kInfinity});
}

/// Cosine and sine of the largest angle that the priors leave between a vector and its image.
struct Cone {
  double cosine = -1, sine = 0;
};

Cone cone_of(const Options& options) {
  if (!options.initial_pose) return {};
  const double angle = options.initial_pose->max_rotation;
  return {elementary::cos(angle), elementary::sin(angle)};
}

/// Whether a scale of the range and a turn within the cone bring `a` to within `reach` of `b`.
bool reaches(const Vector3d& a, const Vector3d& b, const Cone& cone, const ScaleRange& scales,
             double reach) {
  const double squared_length = a.squaredNorm();
  if (squared_length == 0) return b.norm() <= reach;
  // cosine and sine, times |a| |b|, of the angle between the two, and of what the cone leaves of it
  const double dot = a.dot(b), cross = a.cross(b).norm();
  double cosine_left = dot * cone.cosine + cross * cone.sine;
  double sine_left = cross * cone.cosine - dot * cone.sine;
  if (sine_left <= 0) {
    cosine_left = std::sqrt(squared_length * b.squaredNorm());
    sine_left = 0;
  }
  const double off = cosine_left - std::clamp(cosine_left, scales.min * squared_length,
                                              scales.max * squared_length);
  return off * off + sine_left * sine_left <= reach * reach * squared_length;
}

/// Angle of each normal from the direction; 0 where there is no normal.
Eigen::VectorXd inclinations_of(const Points& normals, const Vector3d& direction) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(normals.cols());
  for (Index i = 0; i < normals.cols(); ++i) {
    if (!normals.col(i).isZero(0)) angles[i] = geometry::angle_between(normals.col(i), direction);
  }
  return angles;
}

}  // namespace

bool MatchPriors::say_something(const Options& options) {
  return options.gravity || options.initial_pose || std::isfinite(options.max_translation);
}

MatchPriors::MatchPriors(const OrientedPoints& source, const OrientedPoints& target,
                         const Options& options, double noise_bound)
    : source_(source),
      target_(target),
      options_(options),
      scales_(scales_of(options)),
      target_view_(target.points),
      adaptor_{target_view_},
      tree_(3, adaptor_) {
  if (std::isfinite(options.max_translation)) {
    places_.push_back({Vector3d::Zero(), options.max_translation + noise_bound});
  }
  if (options.initial_pose && std::isfinite(options.initial_pose->max_translation)) {
    places_.push_back({options.initial_pose->target_from_source.translation,
                       options.initial_pose->max_translation + noise_bound});
  }
  by_inclination_.resize(static_cast<std::size_t>(target.points.cols()));
  std::iota(by_inclination_.begin(), by_inclination_.end(), Index{0});
  if (!options.gravity) return;
  source_inclinations_ = inclinations_of(source.normals, options.gravity->source);
  target_inclinations_ = inclinations_of(target.normals, options.gravity->target);
  std::stable_sort(by_inclination_.begin(), by_inclination_.end(), [&](Index a, Index b) {
    return target_inclinations_[a] < target_inclinations_[b];
  });
}

MatchPriors::Ball MatchPriors::ball_of(const Place& place, const Vector3d& expected) const {
  if (!options_.initial_pose) return {place.centre, place.radius + scales_.max * expected.norm()};
  const double middle = (scales_.min + scales_.max) / 2;
  const double chord = 2 * elementary::sin(options_.initial_pose->max_rotation / 2);
  const double spread = scales_.max * chord + (scales_.max - scales_.min) / 2;
  return {place.centre + middle * expected, place.radius + spread * expected.norm()};
}

bool MatchPriors::is_inclined_as(Index i, Index j) const {
  return std::abs(source_inclinations_[i] - target_inclinations_[j]) <=
         options_.gravity->max_tilt + kNormalTolerance;
}

std::vector<Index> MatchPriors::inclined_as(Index i) const {
  if (!options_.gravity) return by_inclination_;
  const double angle = source_inclinations_[i];
  const double most = options_.gravity->max_tilt + kNormalTolerance;
  const auto first =
      std::partition_point(by_inclination_.begin(), by_inclination_.end(),
                           [&](Index j) { return target_inclinations_[j] < angle - most; });
  const auto last = std::partition_point(first, by_inclination_.end(), [&](Index j) {
    return target_inclinations_[j] <= angle + most;
  });
  return {first, last};
}

std::vector<Index> MatchPriors::close_to_images_of(const Vector3d& expected) const {
  Ball smallest{Vector3d::Zero(), kInfinity};
  for (const Place& place : places_) {
    const Ball ball = ball_of(place, expected);
    if (ball.radius < smallest.radius) smallest = ball;
  }
  std::vector<std::pair<std::int32_t, double>> found;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  tree_.radiusSearch(smallest.centre.data(), smallest.radius * smallest.radius, found, unsorted);
  std::vector<Index> close;
  for (const auto& [j, squared_distance] : found) close.push_back(j);
  return close;
}

std::vector<Index> MatchPriors::partners_of(Index i) const {
  const Eigen::Matrix3d turn = options_.initial_pose
                                   ? options_.initial_pose->target_from_source.rotation
                                   : Eigen::Matrix3d::Identity();
  const Vector3d expected = turn * source_.points.col(i), normal = turn * source_.normals.col(i);
  const bool has_ball = !places_.empty() && std::isfinite(scales_.max);
  std::vector<Index> partners = has_ball ? close_to_images_of(expected) : inclined_as(i);

  const Cone cone = cone_of(options_);
  const double widest =
      kNormalTolerance + (options_.initial_pose ? options_.initial_pose->max_rotation : kPi);
  const double least_cosine = widest < kPi ? elementary::cos(widest) : -kInfinity;
  std::erase_if(partners, [&](Index j) {
    if (normal.dot(target_.normals.col(j)) < least_cosine) return true;
    if (has_ball && options_.gravity && !is_inclined_as(i, j)) return true;
    return !std::all_of(places_.begin(), places_.end(), [&](const Place& place) {
      const Vector3d from_centre = target_.points.col(j) - place.centre;
      return reaches(expected, from_centre, cone, scales_, place.radius);
    });
  });
  std::sort(partners.begin(), partners.end());
  return partners;
}

}  // namespace gmcr::frontend
