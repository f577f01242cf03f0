#pragma once

#include <Eigen/Core>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr {

/// What the weighted least-squares alignment of points depends on: sums over the points, so that
/// the moments of a union are the sum of the moments.
struct AlignmentMoments {
  double weight = 0;                                              ///< sum of w_i
  Eigen::Vector3d source = Eigen::Vector3d::Zero();               ///< sum of w_i a_i
  Eigen::Vector3d target = Eigen::Vector3d::Zero();               ///< sum of w_i b_i
  Eigen::Matrix3d target_times_source = Eigen::Matrix3d::Zero();  ///< sum of w_i b_i a_i^T
  double source_squared = 0;                                      ///< sum of w_i |a_i|^2
  double target_squared = 0;                                      ///< sum of w_i |b_i|^2

  void add(double w, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
  AlignmentMoments& operator+=(const AlignmentMoments& other);
  AlignmentMoments operator*(double factor) const;
};

/// Lower bound on  sum_i w_i |b_i - (s R a_i + t)|^2  over all R in SO(3), all t and all s in
/// `scales`; it is the minimum but for rounding, which it stays below.
///
/// max_R tr(R^T H) is the largest eigenvalue of a symmetric 4 x 4 matrix (Horn 1987), found as the
/// largest root of its characteristic polynomial by Newton's method from above (Theobald 2005).
/// Cost O(1): no decomposition.
double least_squares_bound(const AlignmentMoments& moments, const ScaleRange& scales);

}  // namespace gmcr
