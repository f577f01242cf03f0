#include "kernels/consistency_row.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gmcr::kernels {
namespace {

constexpr Index kBlock = 64;

/// One point against many, held as one array a coordinate.
struct PointTo {
  const double *xs, *ys, *zs;
  double x, y, z;

  PointTo(const Eigen::MatrixX3d& points, Index i)
      : xs(points.col(0).data()),
        ys(points.col(1).data()),
        zs(points.col(2).data()),
        x(xs[i]),
        y(ys[i]),
        z(zs[i]) {}

  double distance(Index j) const {
    const double dx = xs[j] - x, dy = ys[j] - y, dz = zs[j] - z;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }
};

}  // namespace

void consistency_row(const CorrespondenceArrays& arrays, Index i, double scale_min,
                     double scale_max, std::span<std::uint64_t> row) {
  const PointTo source(arrays.source, i), target(arrays.target, i);
  const double* bounds = arrays.bounds.data();
  const double bound = bounds[i];
  std::array<std::uint64_t, kBlock> agrees;
  for (Index begin = 0; begin < arrays.size(); begin += kBlock) {
    const Index count = std::min(kBlock, arrays.size() - begin);
    for (Index k = 0; k < count; ++k) {
      const Index j = begin + k;
      const double a = source.distance(j), b = target.distance(j), e = bound + bounds[j];
      agrees[static_cast<std::size_t>(k)] =
          static_cast<std::uint64_t>((b <= scale_max * a + e) & (b + e >= scale_min * a));
    }
    std::uint64_t word = 0;
    for (Index k = 0; k < count; ++k) word |= agrees[static_cast<std::size_t>(k)] << k;
    row[static_cast<std::size_t>(begin / kBlock)] = word;
  }
  row[static_cast<std::size_t>(i / kBlock)] &= ~(std::uint64_t{1} << (i % kBlock));
}

void pair_lengths(const CorrespondenceArrays& arrays, Index i, std::span<double> source_lengths,
                  std::span<double> target_lengths) {
  const PointTo source(arrays.source, i), target(arrays.target, i);
  for (Index j = i + 1; j < arrays.size(); ++j) {
    const auto k = static_cast<std::size_t>(j - i - 1);
    source_lengths[k] = source.distance(j);
    target_lengths[k] = target.distance(j);
  }
}

}  // namespace gmcr::kernels
