#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::problem {

/// Putative correspondences in frames at their own centroids, so that a cloud far from its origin
/// loses no digits.
struct Correspondences {
  Points source, target;  ///< 3 x N, metres, relative to the origins below
  Eigen::ArrayXd bounds;  ///< N inlier bounds eps_i, metres
  Eigen::Vector3d source_origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_origin = Eigen::Vector3d::Zero();

  Index size() const { return source.cols(); }
};

/// Centres both clouds. @param bounds  N inlier bounds, metres.
Correspondences centre(const PointsRef& source, const PointsRef& target,
                       const Eigen::ArrayXd& bounds);

/// The correspondences with the given indices, in that order, same origins.
Correspondences subset(const Correspondences& all, const std::vector<Index>& indices);

/// Transform between the caller's frames from one between the centred frames.
Similarity uncentre(const Similarity& centred, const Correspondences& correspondences);

/// Longest distance of a column from the origin, metres.
double max_norm(const PointsRef& points);

}  // namespace gmcr::problem
