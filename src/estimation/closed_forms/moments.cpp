#include "estimation/closed_forms/moments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gmcr::estimation {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Upper bound on max_R tr(R^T H) over SO(3), tight to rounding.
double largest_alignment(const Eigen::Matrix3d& given) {
  // fourth powers of what weights make of long vectors overflow: a power of two loses no digits
  const double magnitude_of_all = given.cwiseAbs().maxCoeff();
  if (!(magnitude_of_all > 0)) return 0;
  const int exponent = std::ilogb(magnitude_of_all);
  const Eigen::Matrix3d h =
      given.unaryExpr([&](double value) { return std::ldexp(value, -exponent); });
  const Eigen::Vector3d x = h.row(0), y = h.row(1), z = h.row(2);
  const Eigen::Vector3d yz = y.cross(z), zx = z.cross(x), xy = x.cross(y);
  const double p = h.squaredNorm(), determinant = x.dot(yz);
  const double q = yz.squaredNorm() + zx.squaredNorm() + xy.squaredNorm();
  const double above = std::sqrt(3 * p);  // of singular values with that sum of squares
  if (!(above > 0)) return 0;

  // f is convex and rising beyond its largest root, so that Newton's steps come down on it; each
  // takes the rounding of f and of its slope off, so that none steps past it
  constexpr int kMaxSteps = 60;
  const double constant = p * p - 4 * q, magnitude = p * p + 4 * q;
  double root = above;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double squared = root * root, linear = 8 * determinant * root;
    const double value = (squared - 2 * p) * squared - linear + constant;
    const double slope = 4 * (squared - p) * root - 8 * determinant;
    const double value_rounding =
        8 * kEpsilon * ((squared + 2 * p) * squared + std::abs(linear) + magnitude);
    const double slope_rounding =
        8 * kEpsilon * (4 * (squared + p) * root + 8 * std::abs(determinant));
    const double next = root - (value - value_rounding) / (slope + slope_rounding);
    if (!(next < root) || !(slope > 0)) break;
    root = next;
  }
  return std::ldexp(root, exponent);
}

/// Sums of products about the means, of every kLanes-th row each.
template <int kLanes>
class CentredSums {
 public:
  explicit CentredSums(const Moments& about) {
    for (Index axis = 0; axis < 3; ++axis) {
      source_mean_[axis].setConstant(about.source_mean[axis]);
      target_mean_[axis].setConstant(about.target_mean[axis]);
      for (Index other = 0; other < 3; ++other) covariance_[axis][other].setZero();
    }
  }

  /// Adds the rows from i on.
  void add(const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target,
           const Eigen::ArrayXd& weights, Index i) {
    Lanes a[3], b[3];
    for (Index axis = 0; axis < 3; ++axis) {
      a[axis] = Lanes::Map(source.col(axis).data() + i) - source_mean_[axis];
      b[axis] = Lanes::Map(target.col(axis).data() + i) - target_mean_[axis];
    }
    const Lanes w = Lanes::Map(weights.data() + i);
    source_variance_ += w * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    target_variance_ += w * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    for (Index axis = 0; axis < 3; ++axis) {
      const Lanes weighted = w * b[axis];
      for (Index other = 0; other < 3; ++other) covariance_[axis][other] += weighted * a[other];
    }
  }

  void add_to(Moments& m) const {
    for (Index axis = 0; axis < 3; ++axis) {
      for (Index other = 0; other < 3; ++other) {
        m.covariance(axis, other) += covariance_[axis][other].sum();
      }
    }
    m.source_variance += source_variance_.sum();
    m.target_variance += target_variance_.sum();
  }

 private:
  using Lanes = Eigen::Array<double, kLanes, 1>;

  Lanes source_mean_[3], target_mean_[3], covariance_[3][3];
  Lanes source_variance_ = Lanes::Zero(), target_variance_ = Lanes::Zero();
};

}  // namespace

Moments& Moments::operator+=(const Moments& other) {
  const double sum = weight + other.weight;
  if (!(sum > 0)) return *this;
  const Eigen::Vector3d a = other.source_mean - source_mean, b = other.target_mean - target_mean;
  const double share = other.weight / sum, common = weight * share;
  weight = sum;
  source_mean += share * a;
  target_mean += share * b;
  covariance += other.covariance + (common * b) * a.transpose();
  source_variance += other.source_variance + common * a.squaredNorm();
  target_variance += other.target_variance + common * b.squaredNorm();
  return *this;
}

Moments Moments::operator*(double factor) const {
  return {factor * weight,
          source_mean,
          target_mean,
          factor * covariance,
          factor * source_variance,
          factor * target_variance};
}

Moments point_moments(const Eigen::Vector3d& source, const Eigen::Vector3d& target, double weight) {
  Moments m;
  m.weight = weight;
  m.source_mean = source;
  m.target_mean = target;
  return m;
}

Moments measure_moments(const PointsRef& source, const PointsRef& target,
                        const Eigen::ArrayXd& bounds, const std::vector<Index>& indices) {
  const auto count = static_cast<Index>(indices.size());
  Eigen::MatrixX3d a(count, 3), b(count, 3);
  Eigen::ArrayXd weights(count);
  for (Index k = 0; k < count; ++k) {
    const Index i = indices[static_cast<std::size_t>(k)];
    a.row(k) = source.col(i);
    b.row(k) = target.col(i);
    weights[k] = 1 / (bounds[i] * bounds[i]);
  }
  return measure_moments(a, b, weights);
}

Moments measure_moments(const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target,
                        const Eigen::ArrayXd& weights) {
  Moments m;
  m.weight = weights.sum();
  if (!(m.weight > 0)) return m;
  for (Index axis = 0; axis < 3; ++axis) {
    m.source_mean[axis] = (weights * source.col(axis).array()).sum() / m.weight;
    m.target_mean[axis] = (weights * target.col(axis).array()).sum() / m.weight;
  }
  constexpr Index kLanes = 2;  // of the vector registers that every machine has
  const Index num_paired = weights.size() / kLanes * kLanes;
  CentredSums<kLanes> pairs(m);
  for (Index i = 0; i < num_paired; i += kLanes) pairs.add(source, target, weights, i);
  pairs.add_to(m);
  CentredSums<1> rest(m);
  for (Index i = num_paired; i < weights.size(); ++i) rest.add(source, target, weights, i);
  rest.add_to(m);
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
  // t = mean b - s R mean a
  fit.translation = moments.target_mean - fit.scale * (rotation * moments.source_mean);
  return fit;
}

double least_squares_bound(const Moments& m, const ScaleRange& scales) {
  // L5: v_b + s^2 v_a - 2 s max_R tr(R^T H) about the means, where the best translation is none
  const double alignment = largest_alignment(m.covariance);
  const double s = m.source_variance > 0
                       ? std::clamp(alignment / m.source_variance, scales.min, scales.max)
                       : scales.min;
  const double source_part = s * s * m.source_variance;
  // differences of means have the rounding of coordinates
  const double variances = m.target_variance + source_part;
  const double coordinates =
      m.weight * (m.target_mean.squaredNorm() + s * s * m.source_mean.squaredNorm());
  const double rounding =
      64 * kEpsilon * (variances + 2 * s * alignment + std::sqrt(variances * coordinates)) +
      64 * kEpsilon * kEpsilon * coordinates;
  return std::max(0.0, variances - 2 * s * alignment - rounding);
}

}  // namespace gmcr::estimation
