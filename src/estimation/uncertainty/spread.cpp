#include "estimation/uncertainty/spread.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gmcr::estimation {
namespace {

/// Chosen points about their weighted centroid, in place: the sets are large where all is right.
class WeightedPoints {
 public:
  WeightedPoints(const PointsRef& points, const std::vector<Index>& indices,
                 const Eigen::ArrayXd& bounds)
      : points_(points), indices_(indices) {
    // the largest weight is 1: squares of bounds do not vanish
    weights_ = (bounds / bounds.minCoeff()).square().inverse();
    sum_ = weights_.sum();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (Index k = 0; k < size(); ++k) mean += weights_[k] / sum_ * point(k);
    centroid_ = mean;
  }

  Index size() const { return weights_.size(); }
  double weight(Index k) const { return weights_[k] / sum_; }
  Eigen::Vector3d about_centroid(Index k) const { return point(k) - centroid_; }

  Eigen::ArrayXd distances_from_line(const Eigen::Vector3d& axis) const {
    Eigen::ArrayXd distances(size());
    for (Index k = 0; k < size(); ++k) {
      const Eigen::Vector3d p = about_centroid(k);
      distances[k] = (p - axis * axis.dot(p)).norm();
    }
    return distances;
  }

 private:
  Eigen::Vector3d point(Index k) const {
    return points_.col(indices_[static_cast<std::size_t>(k)]);
  }

  const PointsRef& points_;
  const std::vector<Index>& indices_;
  Eigen::ArrayXd weights_;
  double sum_ = 0;
  Eigen::Vector3d centroid_;
};

}  // namespace

Spread measure_spread(const PointsRef& points, const std::vector<Index>& indices,
                      const Eigen::ArrayXd& bounds) {
  if (indices.empty()) return {};
  const WeightedPoints chosen(points, indices, bounds);
  Spread spread;
  spread.from_centroid.resize(chosen.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Index k = 0; k < chosen.size(); ++k) {
    const Eigen::Vector3d p = chosen.about_centroid(k);
    spread.from_centroid[k] = p.norm();
    covariance += (chosen.weight(k) * p) * p.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  spread.from_line = chosen.distances_from_line(eigen.eigenvectors().col(2));
  spread.radius = std::sqrt(covariance.trace());
  return spread;
}

Eigen::ArrayXd distances_from_line(const PointsRef& points, const std::vector<Index>& indices,
                                   const Eigen::ArrayXd& bounds, const Eigen::Vector3d& direction) {
  if (indices.empty()) return {};
  return WeightedPoints(points, indices, bounds).distances_from_line(direction.stableNormalized());
}

}  // namespace gmcr::estimation
