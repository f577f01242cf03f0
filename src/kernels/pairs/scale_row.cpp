#include "kernels/pairs/scale_row.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernels/pairs/scale_row_bounds.hpp"

namespace gmcr::kernels {
namespace {

double distance(const Eigen::MatrixX3d& points, Index i, Index j) {
  const double x = points(j, 0) - points(i, 0), y = points(j, 1) - points(i, 1);
  const double z = points(j, 2) - points(i, 2);
  return std::sqrt(x * x + y * y + z * z);
}

/// Number of edges between bins below a scale of the range.
std::uint64_t edges_below(const ScaleCells& cells, double scale) {
  const auto bits = std::bit_cast<std::uint64_t>(scale);
  const std::uint64_t entry = cells.entries[(bits >> ScaleCells::kShift) - cells.first];
  return (entry + (bits & ScaleCells::kRest)) >> ScaleCells::kShift;
}

}  // namespace

BinSpan covered_bins(const ScaleCells& cells, double lower, double upper, double slack) {
  lower -= slack;
  upper += slack;
  if (!(lower <= cells.max && upper >= cells.min)) return {};
  return BinSpan::of(edges_below(cells, std::max(lower, cells.min)),
                     edges_below(cells, std::min(upper, cells.max)) + 1);
}

BinSpan agreeing_bins(const geometry::CorrespondenceArrays& arrays, const ScaleCells& cells,
                      Index i, Index j) {
  const double a = distance(arrays.source, i, j), b = distance(arrays.target, i, j);
  const double e = arrays.bounds[i] + arrays.bounds[j];
  if (a < kCoincident) {
    return b <= e + cells.max * a ? covered_bins(cells, cells.min, cells.max, 0) : BinSpan{};
  }
  const double inverse = 1 / a;
  // L1: (|bbar| - e) / |abar| <= s <= (|bbar| + e) / |abar|
  const double middle = b * inverse, half = e * inverse;
  const double upper = middle + half;
  return covered_bins(cells, middle - half, upper, kScaleRounding * upper);
}

}  // namespace gmcr::kernels
