#pragma once

#include <Eigen/Core>

#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// Translation that the measurements t_i = b_i - s R a_i agree with best:
/// min_t sum_i |t - t_i|^2 / bounds_i^2.
/// @param measurements  3 x N, N >= 1, metres.
/// @param bounds        N noise bounds, metres, > 0.
Eigen::Vector3d estimate_translation(const PointsRef& measurements, const Eigen::ArrayXd& bounds);

}  // namespace gmcr::estimation
