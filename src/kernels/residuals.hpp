#pragma once

#include <Eigen/Core>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Squared residuals |b_i - (s R a_i + t)|^2.
/// @param source, target  3 x N, metres.
/// @param squared         N values, square metres.
void squared_residuals(const Similarity& target_from_source, const PointsRef& source,
                       const PointsRef& target, Eigen::Ref<Eigen::ArrayXd> squared);

}  // namespace gmcr::kernels
