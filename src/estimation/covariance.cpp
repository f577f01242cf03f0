#include "estimation/covariance.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gmcr::estimation {
namespace {

/// Relative to the whole: a smaller moment of inertia is that of a line, to rounding.
constexpr double kRankTolerance = 1e-12;

/// Weighted moments of the transformed points about their weighted centroid.
struct InlierMoments {
  double weight = 0;                                  ///< sum of w
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();    ///< from t to the centroid
  double squared_radius = 0;                          ///< sum of w |q|^2
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< sum of w (|q|^2 I - q q^T)
  double squared_residuals = 0;                       ///< sum of w |r|^2
};

InlierMoments measure_inliers(const Similarity& pose, const PointsRef& source,
                              const PointsRef& target, const Eigen::ArrayXd& bounds,
                              const std::vector<Index>& indices) {
  InlierMoments moments;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero();
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    moments.weight += weight;
    source_mean += weight * source.col(i);
  }
  source_mean /= moments.weight;
  moments.lever = pose.scale * (pose.rotation * source_mean);
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    const Eigen::Vector3d q = pose.scale * (pose.rotation * (source.col(i) - source_mean));
    moments.squared_radius += weight * q.squaredNorm();
    moments.inertia += weight * (q.squaredNorm() * Eigen::Matrix3d::Identity() - q * q.transpose());
    const double rounding = std::numeric_limits<double>::epsilon() * target.col(i).norm();
    const double residual = (target.col(i) - pose * source.col(i)).norm();
    moments.squared_residuals += weight * std::pow(std::max(residual, rounding), 2);
  }
  return moments;
}

Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// The caller's parameters (omega, tau, sigma) from those about the centroid, where tau' is the
/// motion of the centroid:  tau = tau' - omega x lever - sigma lever.
Eigen::MatrixXd parameters_from_central(const Eigen::Vector3d& lever, Index num_parameters) {
  Eigen::MatrixXd map = Eigen::MatrixXd::Identity(num_parameters, num_parameters);
  map.block<3, 3>(3, 0) = cross_product_matrix(lever);
  if (num_parameters == 7) map.block<3, 1>(3, 6) = -lever;
  return map;
}

}  // namespace

std::optional<Covariance> estimate_covariance(const Similarity& target_from_source,
                                              const PointsRef& source, const PointsRef& target,
                                              const Eigen::ArrayXd& bounds,
                                              const std::vector<Index>& indices,
                                              bool scale_is_free) {
  if (indices.size() < 3) return std::nullopt;
  const InlierMoments moments =
      measure_inliers(target_from_source, source, target, bounds, indices);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(moments.inertia);
  const Eigen::Vector3d& principal = inertia.eigenvalues();
  if (!(principal[0] > kRankTolerance * moments.squared_radius)) return std::nullopt;

  const Index num_parameters = scale_is_free ? 7 : 6;
  const auto num_residuals = static_cast<double>(3 * indices.size());
  const double noise =
      moments.squared_residuals / (num_residuals - static_cast<double>(num_parameters));

  // About the centroid a point q moves by  omega x q + tau' + sigma q.  Since sum w q = 0 and
  // (omega x q) . q = 0, the information matrix is block diagonal.
  Eigen::MatrixXd central = Eigen::MatrixXd::Zero(num_parameters, num_parameters);
  central.topLeftCorner<3, 3>() = noise * inertia.eigenvectors() *
                                  principal.cwiseInverse().asDiagonal() *
                                  inertia.eigenvectors().transpose();
  central.block<3, 3>(3, 3).diagonal().setConstant(noise / moments.weight);
  if (scale_is_free) central(6, 6) = noise / moments.squared_radius;

  Covariance covariance;
  const Eigen::MatrixXd map = parameters_from_central(moments.lever, num_parameters);
  const Eigen::MatrixXd matrix = map * central * map.transpose();
  covariance.matrix = (matrix + matrix.transpose()) / 2;
  // as motions: times the squared RMS radius, which makes that of the scale equal to those of tau'
  covariance.eigenvalues = Eigen::VectorXd::Constant(num_parameters, noise / moments.weight);
  covariance.eigenvalues.head<3>() =
      noise * moments.squared_radius / moments.weight * principal.cwiseInverse();
  std::sort(covariance.eigenvalues.begin(), covariance.eigenvalues.end());
  return covariance;
}

}  // namespace gmcr::estimation
