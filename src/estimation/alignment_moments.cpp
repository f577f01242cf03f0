#include "estimation/alignment_moments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gmcr {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Upper bound on max_R tr(R^T H) over SO(3), tight to rounding.
double largest_alignment(const Eigen::Matrix3d& h) {
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
  return root;
}

}  // namespace

void AlignmentMoments::add(double w, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  weight += w;
  source += w * a;
  target += w * b;
  target_times_source += (w * b) * a.transpose();
  source_squared += w * a.squaredNorm();
  target_squared += w * b.squaredNorm();
}

AlignmentMoments& AlignmentMoments::operator+=(const AlignmentMoments& other) {
  weight += other.weight;
  source += other.source;
  target += other.target;
  target_times_source += other.target_times_source;
  source_squared += other.source_squared;
  target_squared += other.target_squared;
  return *this;
}

AlignmentMoments AlignmentMoments::operator*(double factor) const {
  return {factor * weight,         factor * source,
          factor * target,         factor * target_times_source,
          factor * source_squared, factor * target_squared};
}

double least_squares_bound(const AlignmentMoments& m, const ScaleRange& scales) {
  if (!(m.weight > 0)) return 0;
  // about the centroids the best translation is none
  const Eigen::Matrix3d h = m.target_times_source - m.target * (m.source.transpose() / m.weight);
  const double a = std::max(0.0, m.source_squared - m.source.squaredNorm() / m.weight);
  const double b = std::max(0.0, m.target_squared - m.target.squaredNorm() / m.weight);
  const double alignment = largest_alignment(h);
  const double s = a > 0 ? std::clamp(alignment / a, scales.min, scales.max) : scales.min;
  const double rounding =
      64 * kEpsilon * (m.target_squared + s * s * m.source_squared + 2 * s * alignment);
  return std::max(0.0, b + s * s * a - 2 * s * alignment - rounding);
}

}  // namespace gmcr
