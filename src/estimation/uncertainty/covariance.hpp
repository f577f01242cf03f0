#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "gmcr/result.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// A matrix of the 6 or 7 parameters of `Covariance`.
using ParameterMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 7, 7>;

/// The parameters (omega, tau, sigma) of `Covariance` from those of a motion about a centre c,
/// q -> q + omega x (q - c) + tau' + sigma (q - c):  tau = tau' - omega x lever - sigma lever.
/// @param lever  c - t, metres, target frame.
/// @param num_parameters  6 or 7.
ParameterMatrix parameters_from_central(const Eigen::Vector3d& lever, Index num_parameters);

/// How well correspondences determine the likeliest transform between them.
///
/// First-order covariance of the likeliest fit (`NoiseMixture`): the noise of b_i is taken as
/// isotropic with a standard deviation proportional to bounds_i, its level from the residuals, over
/// three degrees of freedom for each right match less  6  (rigid) or  7. Three inliers give an
/// estimate, if a rough one. A residual counts at least the rounding of its target point: exact
/// data is as sure as its digits.
///
/// Matches near each other may share their error, as key points do whose descriptors see the same
/// surface. How much is measured: with g_i the gradient of the fit by match i, whitened, the
/// covariance grows by  1 + sum g_i . g_j / sum |g_i|^2  over the pairs whose sources and targets
/// are both within kSharedWithin of their tighter bound (Kish 1965: the design effect of a
/// clustered sample), and never shrinks.
/// @param source, target  3 x N, metres.
/// @param bounds          N noise bounds, metres, > 0.
/// @param indices         the m columns to use, those within NoiseMixture::kWindow bounds.
/// @param scale_is_free   whether the scale was estimated too: 7 parameters instead of 6.
/// @return nullopt where m < 3, or where the points are on one line to rounding: then some
///   direction is not determined at all.
/// Cost O(m) and the pairs of at most 2,000 matches spread over them. Works about the centroid, so
/// clouds far from the origin lose no digits; the covariance of t itself is large there, since t is
/// the image of the far origin.
std::optional<Covariance> estimate_covariance(const Similarity& target_from_source,
                                              const PointsRef& source, const PointsRef& target,
                                              const Eigen::ArrayXd& bounds,
                                              const std::vector<Index>& indices,
                                              bool scale_is_free);

}  // namespace gmcr::estimation
