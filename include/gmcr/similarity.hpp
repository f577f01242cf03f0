#pragma once

#include <Eigen/Core>

#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Similarity transform: x_target = scale * rotation * x_source + translation.
///
/// Name a variable by its direction, `target_from_source`, so that composition reads
/// `c_from_a = c_from_b * b_from_a`.
struct Similarity {
  double scale = 1;                                        ///< > 0, no unit
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< orthonormal, det +1
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();   ///< metres, target frame

  /// Image of one point.
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }

  /// Composition: (a * b) * x == a * (b * x).
  Similarity operator*(const Similarity& other) const;

  /// Image of each column of a 3 x N matrix.
  Points apply(const PointsRef& points) const;

  /// The transform back: `source_from_target`.
  Similarity inverse() const;

  /// 4 x 4 homogeneous matrix [scale * rotation, translation; 0 0 0 1].
  Eigen::Matrix4d matrix() const;

  /// Reads a 4 x 4 homogeneous matrix.
  /// @throws std::invalid_argument where it is not a similarity: entries not finite, last row other
  ///   than 0 0 0 1, scale not positive, or rotation not orthonormal to `tolerance` with det +1.
  ///   The rotation that is kept is the closest exact one.
  static Similarity from_matrix(const Eigen::Matrix4d& matrix, double tolerance = 1e-3);
};

}  // namespace gmcr
