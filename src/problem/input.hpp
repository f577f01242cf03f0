#pragma once

#include "gmcr/options.hpp"
#include "gmcr/types.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::problem {

/// @throws std::invalid_argument as `register_correspondences`.
void validate_input(const PointsRef& source, const PointsRef& target, const Options& options);

/// The input as it is, in the caller's frames, with the inlier bounds eps_i = beta_i / c (paper,
/// eq:consensus_set).
Correspondences correspondences_of(const PointsRef& source, const PointsRef& target,
                                   const Options& options);

}  // namespace gmcr::problem
