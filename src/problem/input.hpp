#pragma once

#include <Eigen/Core>

#include "gmcr/options.hpp"
#include "gmcr/types.hpp"

namespace gmcr::problem {

/// @throws std::invalid_argument as `register_correspondences`.
void validate_input(const PointsRef& source, const PointsRef& target, const Options& options);

/// The inlier bounds eps_i = beta_i / c of Eq. (3), metres.
Eigen::ArrayXd inlier_bounds(const Options& options, Index count);

}  // namespace gmcr::problem
