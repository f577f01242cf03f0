#include "estimation/fits/pose_constraints.hpp"

#include <numbers>

namespace gmcr::estimation {

KnownRotation known_rotation(const Priors& priors) {
  constexpr double kHardly = std::numbers::pi / 180;
  if (priors.initial_pose && priors.initial_pose->max_rotation <= kHardly) {
    return KnownRotation::All;
  }
  if (priors.gravity && priors.gravity->max_tilt <= kHardly) return KnownRotation::ButAboutAxis;
  return KnownRotation::None;
}

Index min_correspondences(const Priors& priors, bool scale_is_known) {
  switch (known_rotation(priors)) {
    case KnownRotation::All:
      return scale_is_known ? 1 : 2;
    case KnownRotation::ButAboutAxis:
      return 2;
    case KnownRotation::None:
      break;
  }
  return 3;
}

}  // namespace gmcr::estimation
