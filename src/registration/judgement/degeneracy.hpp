#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::registration {

/// Why the inliers do not determine the transform; empty where they do.
///
/// Points of which each stays within half its noise bound when they are turned about a line, or
/// scaled about a point, say nothing about that turn or scale. What the priors fix needs no points.
/// @param bounds  of the inliers, metres.
std::string degeneracy_reason(const PointsRef& source, const Similarity& pose,
                              const std::vector<Index>& inliers, const Eigen::ArrayXd& bounds,
                              const Options& options);

}  // namespace gmcr::registration
