#include "estimation/closed_forms/scale.hpp"

#include <cmath>

namespace gmcr::estimation {

double estimate_scale(const Eigen::ArrayXd& scales, const Eigen::ArrayXd& alphas) {
  double weighted_sum = 0, weight_sum = 0;
  for (Eigen::Index k = 0; k < scales.size(); ++k) {
    if (!std::isfinite(alphas[k])) continue;
    const double weight = 1 / (alphas[k] * alphas[k]);
    weighted_sum += weight * scales[k];
    weight_sum += weight;
  }
  // s = sum_k s_k / alpha_k^2 / sum_k 1 / alpha_k^2
  return weighted_sum / weight_sum;
}

}  // namespace gmcr::estimation
