#pragma once

#include <Eigen/Core>

namespace gmcr::estimation {

/// Scale that the measurements agree with best: min_s sum_k (s - s_k)^2 / alpha_k^2, the closed
/// form of the paper's scale objective, Eq. (10), without outliers.
/// @param scales, alphas  K values each, K >= 1; a measurement with an infinite alpha weighs
/// nothing.
/// @return the weighted mean; NaN where no measurement has weight.
double estimate_scale(const Eigen::ArrayXd& scales, const Eigen::ArrayXd& alphas);

}  // namespace gmcr::estimation
