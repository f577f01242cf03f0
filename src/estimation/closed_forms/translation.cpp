#include "estimation/closed_forms/translation.hpp"

namespace gmcr::estimation {

Eigen::Vector3d estimate_translation(const PointsRef& measurements, const Eigen::ArrayXd& bounds) {
  const Eigen::VectorXd weights = bounds.square().inverse().matrix();
  // t = sum_i t_i / eps_i^2 / sum_i 1 / eps_i^2
  return measurements * weights / weights.sum();
}

}  // namespace gmcr::estimation
