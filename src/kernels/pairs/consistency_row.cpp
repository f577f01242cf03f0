#include "kernels/pairs/consistency_row.hpp"

#include <algorithm>
#include <cmath>

namespace gmcr::kernels {
namespace {

struct Difference {
  double x, y, z;
  double squared_norm() const { return x * x + y * y + z * z; }
};

Difference difference(const Eigen::MatrixX3d& points, Index i, Index j) {
  return {points(j, 0) - points(i, 0), points(j, 1) - points(i, 1), points(j, 2) - points(i, 2)};
}

}  // namespace

bool is_consistent(const geometry::CorrespondenceArrays& arrays, Index i, Index j, double scale_min,
                   double scale_max) {
  const double a = difference(arrays.source, i, j).squared_norm();
  const double b = difference(arrays.target, i, j).squared_norm();
  const double e = arrays.bounds[i] + arrays.bounds[j];
  const double ee = e * e;
  // L1: |b| <= scale_max |a| + e and |b| + e >= scale_min |a|, squared twice
  const double longest = (scale_max * scale_max) * a, shortest = (scale_min * scale_min) * a;
  const double over = (b - longest) - ee, under = (shortest - b) - ee;
  const bool not_too_long = (over <= 0) | (over * over <= (4 * ee) * longest);
  const bool not_too_short = (under <= 0) | (under * under <= (4 * ee) * b);
  return not_too_long & not_too_short;
}

void consistency_row_reference(const geometry::CorrespondenceArrays& arrays, Index i,
                               double scale_min, double scale_max, std::span<std::uint64_t> row) {
  std::fill(row.begin(), row.end(), 0);
  for (Index j = 0; j < arrays.size(); ++j) {
    if (j == i || !is_consistent(arrays, i, j, scale_min, scale_max)) continue;
    row[static_cast<std::size_t>(j / 64)] |= std::uint64_t{1} << (j % 64);
  }
}

}  // namespace gmcr::kernels
