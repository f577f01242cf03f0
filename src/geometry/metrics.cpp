#include "gmcr/metrics.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "geometry/elementary.hpp"

namespace gmcr {

double rotation_error_deg(const Eigen::Matrix3d& estimate, const Eigen::Matrix3d& truth) {
  const Eigen::Quaterniond difference(Eigen::Matrix3d(estimate.transpose() * truth));
  const double angle = 2 * elementary::atan2(difference.vec().norm(), std::abs(difference.w()));
  return angle * 180 / std::numbers::pi;
}

double translation_error(const Eigen::Vector3d& estimate, const Eigen::Vector3d& truth) {
  return (estimate - truth).norm();
}

double scale_error(double estimate, double truth) { return std::abs(estimate / truth - 1); }

double mean_point_error(const Similarity& estimate, const Similarity& truth,
                        const PointsRef& points) {
  if (points.cols() == 0) throw std::invalid_argument("points: empty");
  return (estimate.apply(points) - truth.apply(points)).colwise().norm().mean();
}

}  // namespace gmcr
