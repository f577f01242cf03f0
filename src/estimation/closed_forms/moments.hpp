#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// All that a weighted least-squares fit of a similarity depends on. Those of a union are the sum
/// of the moments.
struct Moments {
  double weight = 0;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< sum w_i b_i a_i^T about the means
  double source_variance = 0;                            ///< sum w_i |a_i|^2 about the mean
  double target_variance = 0;                            ///< sum w_i |b_i|^2 about the mean

  Moments& operator+=(const Moments& other);
  Moments operator*(double factor) const;  ///< all weights times `factor`, >= 0
};

/// Each correspondence weighs 1 / bounds_i^2.
/// @param source, target  3 x N, metres.  @param bounds  N noise bounds, metres, > 0.
/// @param indices  the columns to use, at least one. Cost O(number of indices).
Moments measure_moments(const PointsRef& source, const PointsRef& target,
                        const Eigen::ArrayXd& bounds, const std::vector<Index>& indices);

/// The same of all rows, each with its own weight.
/// @param source, target  N x 3, metres.
/// @param weights  N values >= 0; where all are 0, so are the moments. Cost O(N), no allocation.
Moments measure_moments(const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target,
                        const Eigen::ArrayXd& weights);

/// Moments of one correspondence of the given weight, > 0.
Moments point_moments(const Eigen::Vector3d& source, const Eigen::Vector3d& target, double weight);

/// Best scale and translation for a rotation (Umeyama 1991): tr(R^T H) over the source variance,
/// kept in the range, and the difference of the means.
Similarity fit_with_rotation(const Moments& moments, const Eigen::Matrix3d& rotation,
                             const ScaleRange& scales);

/// Lower bound on  sum_i w_i |b_i - (s R a_i + t)|^2  over all R in SO(3), all t and all s in
/// `scales`; it is the minimum but for rounding, which it stays below.
///
/// max_R tr(R^T H) is the largest eigenvalue of a symmetric 4 x 4 matrix (Horn 1987), found as the
/// largest root of its characteristic polynomial by Newton's method from above (Theobald 2005).
/// Cost O(1): no decomposition.
double least_squares_bound(const Moments& moments, const ScaleRange& scales);

}  // namespace gmcr::estimation
