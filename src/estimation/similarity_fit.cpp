#include "estimation/similarity_fit.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

#include "estimation/rotation.hpp"

namespace gmcr {
namespace {

/// The least rotation that turns the axis of a cross-covariance of rank 1 onto its image.
Eigen::Matrix3d least_rotation(const Eigen::Matrix3d& covariance) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()[0] > 0)) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d from = svd.matrixV().col(0), to = svd.matrixU().col(0);
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

}  // namespace

std::optional<Similarity> fit_similarity(const PointsRef& source, const PointsRef& target,
                                         const Eigen::ArrayXd& bounds,
                                         const std::vector<Index>& indices,
                                         const ScaleRange& scales) {
  if (indices.size() < 3) return std::nullopt;
  double weight_sum = 0;
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero(), target_mean = Eigen::Vector3d::Zero();
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    weight_sum += weight;
    source_mean += weight * source.col(i);
    target_mean += weight * target.col(i);
  }
  source_mean /= weight_sum;
  target_mean /= weight_sum;

  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double source_variance = 0;
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    const Eigen::Vector3d a = source.col(i) - source_mean, b = target.col(i) - target_mean;
    covariance += weight * b * a.transpose();
    source_variance += weight * a.squaredNorm();
  }
  const std::optional<Eigen::Matrix3d> unique = rotation_from_covariance(covariance);
  const Eigen::Matrix3d rotation = unique ? *unique : least_rotation(covariance);

  // Umeyama (1991): the scale is tr(R^T H) over the source variance
  const double optimal_scale =
      source_variance > 0 ? rotation.cwiseProduct(covariance).sum() / source_variance : 1;
  Similarity fit;
  fit.scale = std::clamp(optimal_scale, scales.min, scales.max);
  fit.rotation = rotation;
  fit.translation = target_mean - fit.scale * (rotation * source_mean);
  return fit;
}

}  // namespace gmcr
