#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/closed_forms/moments.hpp"
#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// Similarity that maps chosen points of `source` onto those of `target` best in the least-squares
/// sense: min sum_i |b_i - (s R a_i + t)|^2 / bounds_i^2 (Umeyama 1991).
/// @param source, target  3 x N, metres.
/// @param bounds          N noise bounds, metres, > 0.
/// @param indices         the columns to use.
/// @param scales          where the scale must lie; min == max: it is known.
/// @return nullopt where fewer than 3 columns are given. Where the columns span less than a plane
///   the rotation is one of many, the one that turns the least; where they coincide so is the
///   scale.
/// Cost O(number of indices).
std::optional<Similarity> fit_similarity(const PointsRef& source, const PointsRef& target,
                                         const Eigen::ArrayXd& bounds,
                                         const std::vector<Index>& indices,
                                         const ScaleRange& scales);

/// The same for correspondences of the given moments.
Similarity fit_similarity(const Moments& moments, const ScaleRange& scales);

}  // namespace gmcr::estimation
