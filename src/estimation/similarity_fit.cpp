#include "estimation/similarity_fit.hpp"

#include <algorithm>

#include "estimation/rotation.hpp"

namespace gmcr {

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
  const std::optional<Eigen::Matrix3d> rotation = rotation_from_covariance(covariance);
  if (!rotation) return std::nullopt;

  // Umeyama (1991): the scale is tr(R^T H) over the source variance
  const double optimal_scale = rotation->cwiseProduct(covariance).sum() / source_variance;
  Similarity fit;
  fit.scale = std::clamp(optimal_scale, scales.min, scales.max);
  fit.rotation = *rotation;
  fit.translation = target_mean - fit.scale * (*rotation * source_mean);
  return fit;
}

}  // namespace gmcr
