#include "estimation/uncertainty/covariance.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "estimation/uncertainty/noise_mixture.hpp"
#include "geometry/close_pairs.hpp"

namespace gmcr::estimation {
namespace {

/// Relative to the whole: a smaller moment of inertia is that of a line, to rounding.
constexpr double kRankTolerance = 1e-12;

/// Pairs of matches nearer than so many of their tighter bound may share their error: about the
/// radius of a feature where the bound is that of its key point.
constexpr double kSharedWithin = 3;
constexpr Index kMaxShared = 2000;  ///< matches whose pairs are looked at

// of the 6 or 7 parameters: sizes that the compiler knows to be small
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 7, 1>;

/// The correspondences that a fit uses, each with what it says.
struct Residuals {
  Eigen::Matrix3Xd lever;     ///< q: from the centroid of the transformed sources
  Eigen::Matrix3Xd residual;  ///< b - (s R a + t)
  Eigen::ArrayXd right;       ///< probability that the match is right, over the squared bound
  Eigen::ArrayXd pull;        ///< what the residual weighs in the fit
  Eigen::Vector3d centroid_lever = Eigen::Vector3d::Zero();  ///< from t to the centroid
  double noise = 0;  ///< variance of an axis, in squared bounds
  double information = 1;

  Index size() const { return lever.cols(); }
};

Residuals measure_residuals(const Similarity& pose, const PointsRef& source,
                            const PointsRef& target, const Eigen::ArrayXd& bounds,
                            const std::vector<Index>& indices, Index num_parameters) {
  const auto count = static_cast<Index>(indices.size());
  Residuals r;
  r.lever.resize(3, count);
  r.residual.resize(3, count);
  Eigen::ArrayXd squares(count), inverse_bounds(count);
  for (Index k = 0; k < count; ++k) {
    const Index i = indices[static_cast<std::size_t>(k)];
    r.lever.col(k) = pose.scale * (pose.rotation * source.col(i));
    r.residual.col(k) = target.col(i) - pose * source.col(i);
    const double rounding = std::numeric_limits<double>::epsilon() * target.col(i).norm();
    const double length = std::max(r.residual.col(k).norm(), rounding);
    inverse_bounds[k] = 1 / (bounds[i] * bounds[i]);
    squares[k] = length * length * inverse_bounds[k];
  }
  const NoiseMixture mixture = fit_noise(squares);
  const Eigen::ArrayXd right = mixture.right(squares), weights = mixture.weights(squares);
  const double freedom = std::max(3 * right.sum() - static_cast<double>(num_parameters), 1.0);
  r.noise = (right * weights * squares).sum() / freedom;
  r.information = mixture.information();
  r.right = right * inverse_bounds;
  r.pull = r.right * weights;
  r.centroid_lever = (r.lever * r.right.matrix()) / r.right.sum();
  r.lever.colwise() -= r.centroid_lever;
  return r;
}

/// Weighted moments of the transformed points about their weighted centroid.
struct Inertia {
  double weight = 0;                                 ///< sum of w
  double squared_radius = 0;                         ///< sum of w |q|^2
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();  ///< sum of w (|q|^2 I - q q^T)
};

Inertia measure_inertia(const Residuals& r) {
  Inertia inertia;
  inertia.weight = r.right.sum();
  for (Index k = 0; k < r.size(); ++k) {
    const auto q = r.lever.col(k);
    inertia.squared_radius += r.right[k] * q.squaredNorm();
    inertia.matrix +=
        r.right[k] * (q.squaredNorm() * Eigen::Matrix3d::Identity() - q * q.transpose());
  }
  return inertia;
}

/// By how much errors that near matches share enlarge the covariance, >= 1.
/// @param central  covariance of the parameters about the centroid.
double design_effect(const Residuals& r, const ParameterMatrix& central, const PointsRef& source,
                     const PointsRef& target, const Eigen::ArrayXd& bounds,
                     const std::vector<Index>& indices, double scale) {
  const ParameterMatrix whiten = central.llt().matrixL().transpose();
  const Index count = std::min(r.size(), kMaxShared);
  std::vector<Index> chosen;  // spread evenly
  Points ends(3, count);
  Eigen::ArrayXd radii(count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 7> gradients(
      central.rows(), count);
  for (Index c = 0; c < count; ++c) {
    const Index k = c * r.size() / count;
    chosen.push_back(indices[static_cast<std::size_t>(k)]);
    ends.col(c) = target.col(chosen.back());
    radii[c] = kSharedWithin / 2 * bounds[chosen.back()];
    const Eigen::Vector3d pull = r.pull[k] * r.residual.col(k);
    Parameters gradient(central.rows());
    gradient.head<3>() = r.lever.col(k).cross(pull);
    gradient.segment<3>(3) = pull;
    if (central.rows() == 7) gradient[6] = r.lever.col(k).dot(pull);
    gradients.col(c) = whiten * gradient;
  }
  const double own = gradients.squaredNorm();
  if (!(own > 0)) return 1;
  double shared = 0;
  geometry::for_each_close_pair(ends, radii, [&](Index c, Index d, double radius) {
    const Eigen::Vector3d between = source.col(chosen[static_cast<std::size_t>(d)]) -
                                    source.col(chosen[static_cast<std::size_t>(c)]);
    if (scale * between.norm() <= radius) shared += 2 * gradients.col(c).dot(gradients.col(d));
    return true;
  });
  // of a part, each match has only that part of its neighbours
  const double skipped = static_cast<double>(r.size()) / static_cast<double>(count);
  return std::max(1.0, 1 + skipped * shared / own);
}

Eigen::Matrix3d cross_product_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

ParameterMatrix parameters_from_central(const Eigen::Vector3d& lever, Index num_parameters) {
  ParameterMatrix map = ParameterMatrix::Identity(num_parameters, num_parameters);
  map.block<3, 3>(3, 0) = cross_product_matrix(lever);
  if (num_parameters == 7) map.block<3, 1>(3, 6) = -lever;
  return map;
}

std::optional<Covariance> estimate_covariance(const Similarity& target_from_source,
                                              const PointsRef& source, const PointsRef& target,
                                              const Eigen::ArrayXd& bounds,
                                              const std::vector<Index>& indices,
                                              bool scale_is_free) {
  if (indices.size() < 3) return std::nullopt;
  const Index num_parameters = scale_is_free ? 7 : 6;
  const Residuals residuals =
      measure_residuals(target_from_source, source, target, bounds, indices, num_parameters);
  const Inertia inertia = measure_inertia(residuals);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia.matrix);
  const Eigen::Vector3d& principal = axes.eigenvalues();
  if (!(principal[0] > kRankTolerance * inertia.squared_radius)) return std::nullopt;

  // About the centroid a point q moves by  omega x q + tau' + sigma q.  Since sum w q = 0 and
  // (omega x q) . q = 0, the information matrix is block diagonal.
  const double variance = residuals.noise / residuals.information;
  ParameterMatrix central = ParameterMatrix::Zero(num_parameters, num_parameters);
  central.topLeftCorner<3, 3>() = variance * axes.eigenvectors() *
                                  principal.cwiseInverse().asDiagonal() *
                                  axes.eigenvectors().transpose();
  central.block<3, 3>(3, 3).diagonal().setConstant(variance / inertia.weight);
  if (scale_is_free) central(6, 6) = variance / inertia.squared_radius;
  const double effect =
      design_effect(residuals, central, source, target, bounds, indices, target_from_source.scale);
  central *= effect;

  Covariance covariance;
  const ParameterMatrix map = parameters_from_central(residuals.centroid_lever, num_parameters);
  const ParameterMatrix matrix = map * central * map.transpose();
  covariance.matrix = (matrix + matrix.transpose()) / 2;
  // as motions: times the squared RMS radius, which makes that of the scale equal to those of tau'
  covariance.eigenvalues =
      Eigen::VectorXd::Constant(num_parameters, effect * variance / inertia.weight);
  covariance.eigenvalues.head<3>() =
      effect * variance * inertia.squared_radius / inertia.weight * principal.cwiseInverse();
  std::sort(covariance.eigenvalues.begin(), covariance.eigenvalues.end());
  return covariance;
}

}  // namespace gmcr::estimation
