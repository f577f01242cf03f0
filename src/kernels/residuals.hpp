#pragma once

#include <Eigen/Core>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Squared residuals |b_i - (s R a_i + t)|^2.
/// @param source, target  N x 3, metres.
/// @return N values, square metres.
Eigen::ArrayXd squared_residuals(const Similarity& target_from_source,
                                 const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target);

}  // namespace gmcr::kernels
