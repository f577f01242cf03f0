#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/closed_forms/moments.hpp"
#include "estimation/fits/pose_constraints.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// The fit of `fit_similarity` among the poses that the constraints admit.
/// @param source, target, bounds, indices  as for `fit_similarity`, in the centred frames.
/// @return nullopt where fewer columns than `min_correspondences` are given, and where no admitted
/// pose is found.
std::optional<Similarity> fit_pose(const PointsRef& source, const PointsRef& target,
                                   const Eigen::ArrayXd& bounds, const std::vector<Index>& indices,
                                   const PoseConstraints& constraints);

/// The same for correspondences of the given moments.
std::optional<Similarity> fit_pose(const Moments& moments, const PoseConstraints& constraints);

}  // namespace gmcr::estimation
