#pragma once

#include <Eigen/Geometry>

#include "frontend/alignment/plane_pairs.hpp"

namespace gmcr::frontend {

/// Inverse of the sum of the covariances of two plane patches, each (1, 1, kFlatness along its
/// normal), in units in which two parallel patches weigh 1 along their normal: with a and b the
/// normals,  isotropic I + sum (a + b)(a + b)' + difference (a - b)(a - b)'.
///
/// a + b, a - b and a x b are eigenvectors of  2 I - (1 - f)(a a' + b b'),  with the eigenvalues
/// 2 - (1 - f)(1 + a b), 2 - (1 - f)(1 - a b) and 2.
struct PlaneMetric {
  static constexpr double isotropic = kFlatness;
  double sum, difference;

  explicit PlaneMetric(double cosine) : sum(share(1 + cosine)), difference(share(1 - cosine)) {}

  static double share(double eigenvalue) {
    return kFlatness * (1 - kFlatness) / (4 - 2 * (1 - kFlatness) * eigenvalue);
  }
};

/// Change of  n . x  with each of the seven parameters in metres, of a point at `arm` levers from
/// the pivot.
inline MotionStep along(const Eigen::Vector3d& n, const Eigen::Vector3d& arm) {
  MotionStep step;
  step << arm.cross(n), n, arm.dot(n);
  return step;
}

/// Half the derivative of the squared distance of a pair by such a motion.
inline MotionStep pull_of(const PlanePair& pair, const Eigen::Vector3d& arm) {
  const PlaneMetric metric(pair.normal.dot(pair.moved_normal));
  const Eigen::Vector3d sum = pair.moved_normal + pair.normal;
  const Eigen::Vector3d difference = pair.moved_normal - pair.normal;
  return along(PlaneMetric::isotropic * pair.residual + metric.sum * pair.residual.dot(sum) * sum +
                   metric.difference * pair.residual.dot(difference) * difference,
               arm);
}

/// Of Geman and McClure, times the agreement of the normals.
inline double weight_of(const PlanePair& pair, double kernel) {
  const double ratio = kernel * kernel / (kernel * kernel + pair.squared_distance);
  return pair.agreement * ratio * ratio;
}

}  // namespace gmcr::frontend
