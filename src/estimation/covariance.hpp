#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "gmcr/result.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// How well chosen correspondences determine the least-squares transform between them.
///
/// First-order covariance of the minimiser of  sum_i |b_i - (s R a_i + t)|^2 / bounds_i^2 :  the
/// noise of b_i is taken as isotropic with a standard deviation proportional to bounds_i, its level
/// from the residuals,  sum_i |r_i|^2 / bounds_i^2  over  3 m - 6  (rigid) or  3 m - 7  degrees of
/// freedom; that is at least 2 for m >= 3, so three inliers give an estimate, if a rough one. A
/// residual counts at least the rounding of its target point: exact data is as sure as its digits.
/// @param source, target  3 x N, metres.
/// @param bounds          N noise bounds, metres, > 0.
/// @param indices         the m columns to use, those near the transform.
/// @param scale_is_free   whether the scale was estimated too: 7 parameters instead of 6.
/// @return nullopt where m < 3, or where the points are on one line to rounding: then some
///   direction is not determined at all.
/// Cost O(m). Works about the centroid, so clouds far from the origin lose no digits; the
/// covariance of t itself is large there, since t is the image of the far origin.
std::optional<Covariance> estimate_covariance(const Similarity& target_from_source,
                                              const PointsRef& source, const PointsRef& target,
                                              const Eigen::ArrayXd& bounds,
                                              const std::vector<Index>& indices,
                                              bool scale_is_free);

}  // namespace gmcr::estimation
