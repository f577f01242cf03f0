#pragma once

#include <string>
#include <vector>

#include "gmcr/priors.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::registration {

/// Why the inliers do not determine the transform; empty where they do.
///
/// Points that stay within half the noise bound when turned about a line, or scaled about a point,
/// say nothing about that turn or scale.
/// @param bound  the largest noise bound of the inliers, metres.
std::string degeneracy_reason(const Points& source, const Similarity& pose,
                              const std::vector<Index>& inliers, double bound,
                              const Priors& priors);

}  // namespace gmcr::registration
