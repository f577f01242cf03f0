#include "estimation/moments.hpp"

#include <algorithm>

namespace gmcr {

Moments measure_moments(const PointsRef& source, const PointsRef& target,
                        const Eigen::ArrayXd& bounds, const std::vector<Index>& indices) {
  Moments m;
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    m.weight += weight;
    m.source_mean += weight * source.col(i);
    m.target_mean += weight * target.col(i);
  }
  m.source_mean /= m.weight;
  m.target_mean /= m.weight;
  for (const Index i : indices) {
    const double weight = 1 / (bounds[i] * bounds[i]);
    const Eigen::Vector3d a = source.col(i) - m.source_mean, b = target.col(i) - m.target_mean;
    m.covariance += weight * b * a.transpose();
    m.source_variance += weight * a.squaredNorm();
  }
  return m;
}

Moments with_correspondence(const Moments& moments, const Eigen::Vector3d& source,
                            const Eigen::Vector3d& target, double weight) {
  Moments m = moments;
  const Eigen::Vector3d a = source - moments.source_mean, b = target - moments.target_mean;
  m.weight += weight;
  const double share = weight / m.weight;
  m.source_mean += share * a;
  m.target_mean += share * b;
  m.covariance += (share * moments.weight) * b * a.transpose();
  m.source_variance += share * moments.weight * a.squaredNorm();
  return m;
}

Similarity fit_with_rotation(const Moments& moments, const Eigen::Matrix3d& rotation,
                             const ScaleRange& scales) {
  const double optimal_scale =
      moments.source_variance > 0
          ? rotation.cwiseProduct(moments.covariance).sum() / moments.source_variance
          : 1;
  Similarity fit;
  fit.scale = std::clamp(optimal_scale, scales.min, scales.max);
  fit.rotation = rotation;
  fit.translation = moments.target_mean - fit.scale * (rotation * moments.source_mean);
  return fit;
}

}  // namespace gmcr
