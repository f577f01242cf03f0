#include "kernels/pairs/rotation_row.hpp"

#include <algorithm>
#include <cmath>

namespace gmcr::kernels {
namespace {

double dot(const Eigen::MatrixX3d& directions, Index k, Index l) {
  return directions(k, 0) * directions(l, 0) + directions(k, 1) * directions(l, 1) +
         directions(k, 2) * directions(l, 2);
}

double sine(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }

}  // namespace

bool shares_rotation(const DirectionArrays& arrays, Index k, Index l) {
  const double cos_k = arrays.cos_gamma[k], sin_k = arrays.sin_gamma[k];
  const double cos_l = arrays.cos_gamma[l], sin_l = arrays.sin_gamma[l];
  // sin(gamma_k + gamma_l) <= 0: the cones are half a turn wide together, so any rotation does
  const bool wide =
      sin_k * cos_l + cos_k * sin_l <= 0 && (sin_k > 0 || sin_l > 0 || cos_k < 0 || cos_l < 0);
  const double cos_a = dot(arrays.source, k, l), cos_b = dot(arrays.target, k, l);
  // Eq. (15), L3: cos(angle(a_k, a_l) - angle(b_k, b_l)) >= cos(gamma_k + gamma_l)
  const double cos_difference = cos_a * cos_b + sine(cos_a) * sine(cos_b);
  return wide | (cos_difference + kCosineSlack >= cos_k * cos_l - sin_k * sin_l);
}

void rotation_row_reference(const DirectionArrays& arrays, Index k, std::span<std::uint64_t> row) {
  std::fill(row.begin(), row.end(), 0);
  for (Index l = 0; l < arrays.size(); ++l) {
    const bool agrees = l != k && shares_rotation(arrays, k, l);
    row[static_cast<std::size_t>(l / 64)] |= std::uint64_t{agrees} << (l % 64);
  }
}

}  // namespace gmcr::kernels
