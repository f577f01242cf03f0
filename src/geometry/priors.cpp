#include "gmcr/priors.hpp"

#include <cmath>

#include "geometry/angles.hpp"

namespace gmcr {
namespace {

/// Whether a translation is within `radius` of `centre`, to rounding.
bool within(const Eigen::Vector3d& translation, const Eigen::Vector3d& centre, double radius) {
  if (std::isinf(radius)) return true;
  constexpr double kRounding = 1e-12;
  const double size = translation.norm() + centre.norm() + radius;
  return (translation - centre).norm() <= radius + kRounding * size;
}

}  // namespace

bool Priors::admit(const Similarity& target_from_source) const {
  const Eigen::Matrix3d& rotation = target_from_source.rotation;
  const Eigen::Vector3d& translation = target_from_source.translation;
  if (gravity && geometry::tilt(*gravity, rotation) > gravity->max_tilt + geometry::kAngleSlack)
    return false;
  if (initial_pose) {
    if (geometry::turn_from(*initial_pose, rotation) >
        initial_pose->max_rotation + geometry::kAngleSlack)
      return false;
    if (!within(translation, initial_pose->target_from_source.translation,
                initial_pose->max_translation)) {
      return false;
    }
  }
  return within(translation, Eigen::Vector3d::Zero(), max_translation);
}

}  // namespace gmcr
