#include "gmcr/priors.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include "geometry/angles.hpp"

namespace gmcr {
namespace {

template <typename Value>
void require(bool holds, const std::string& field, const Value& value, const char* rule) {
  if (holds) return;
  std::ostringstream message;
  message << "priors." << field << ": " << value << ' ' << rule;
  throw std::invalid_argument(message.str());
}

void require_angle(const std::string& field, double angle) {
  // pi itself may come rounded
  require(angle >= 0 && angle <= std::numbers::pi + geometry::kAngleSlack, field, angle,
          "is not an angle in [0, pi]");
}

void require_direction(const std::string& field, const Eigen::Vector3d& direction) {
  require(direction.allFinite() && direction.stableNorm() > 0, field, direction.transpose(),
          "is not a direction: it must be finite and not zero");
}

bool is_rotation(const Eigen::Matrix3d& matrix) {
  constexpr double kTolerance = 1e-6;
  return matrix.allFinite() && matrix.determinant() > 0 &&
         (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
             kTolerance;
}

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

void Priors::validate() const {
  if (gravity) {
    require_direction("gravity.source", gravity->source);
    require_direction("gravity.target", gravity->target);
    require_angle("gravity.max_tilt", gravity->max_tilt);
  }
  if (initial_pose) {
    const Similarity& pose = initial_pose->target_from_source;
    require(is_rotation(pose.rotation), "initial_pose.target_from_source.rotation", pose.rotation,
            "is not orthonormal with determinant 1");
    require(pose.translation.allFinite(), "initial_pose.target_from_source.translation",
            pose.translation.transpose(), "is not finite");
    require_angle("initial_pose.max_rotation", initial_pose->max_rotation);
    require(initial_pose->max_translation >= 0, "initial_pose.max_translation",
            initial_pose->max_translation, "is not a distance >= 0");
  }
  require(max_translation > 0, "max_translation", max_translation, "is not a distance > 0");
}

}  // namespace gmcr
