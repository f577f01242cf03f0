#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr {

/// All that a least-squares fit of a similarity needs of its correspondences; each weighs
/// 1 / bounds_i^2.
struct Moments {
  double weight = 0;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< sum w_i b_i a_i^T about the means
  double source_variance = 0;                            ///< sum w_i |a_i|^2 about the mean
};

/// @param source, target  3 x N, metres.  @param bounds  N noise bounds, metres, > 0.
/// @param indices  the columns to use, at least one. Cost O(number of indices).
Moments measure_moments(const PointsRef& source, const PointsRef& target,
                        const Eigen::ArrayXd& bounds, const std::vector<Index>& indices);

/// The moments with one more correspondence of the given weight, > 0.
Moments with_correspondence(const Moments& moments, const Eigen::Vector3d& source,
                            const Eigen::Vector3d& target, double weight);

/// Best scale and translation for a rotation (Umeyama 1991): tr(R^T H) over the source variance,
/// kept in the range, and the difference of the means.
Similarity fit_with_rotation(const Moments& moments, const Eigen::Matrix3d& rotation,
                             const ScaleRange& scales);

}  // namespace gmcr
