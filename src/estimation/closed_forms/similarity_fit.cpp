#include "estimation/closed_forms/similarity_fit.hpp"

#include <algorithm>

#include "estimation/closed_forms/rotation.hpp"

namespace gmcr::estimation {

std::optional<Similarity> fit_similarity(const PointsRef& source, const PointsRef& target,
                                         const Eigen::ArrayXd& bounds,
                                         const std::vector<Index>& indices,
                                         const ScaleRange& scales) {
  if (indices.size() < 3) return std::nullopt;
  return fit_similarity(measure_moments(source, target, bounds, indices), scales);
}

Similarity fit_similarity(const Moments& moments, const ScaleRange& scales) {
  const std::optional<Eigen::Matrix3d> unique = rotation_from_covariance(moments.covariance);
  return fit_with_rotation(moments, unique ? *unique : least_rotation(moments.covariance), scales);
}

}  // namespace gmcr::estimation
