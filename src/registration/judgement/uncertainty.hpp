#pragma once

#include <vector>

#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::registration {

/// Covariance and consistent scales of a transform.
/// @param inliers   its consensus set.
/// @param deadline  ends the intersection of the scales.
/// @return no covariance where the inliers are on one line to rounding.
Uncertainty measure_uncertainty(const problem::CallerPose& pose,
                                const problem::CallerCorrespondences& input,
                                const std::vector<Index>& inliers, const Options& options,
                                const parallel::Deadline& deadline);

}  // namespace gmcr::registration
