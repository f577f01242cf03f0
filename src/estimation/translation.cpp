#include "estimation/translation.hpp"

namespace gmcr::estimation {

Eigen::Vector3d estimate_translation(const PointsRef& measurements, const Eigen::ArrayXd& bounds) {
  const Eigen::VectorXd weights = bounds.square().inverse().matrix();
  return measurements * weights / weights.sum();
}

}  // namespace gmcr::estimation
