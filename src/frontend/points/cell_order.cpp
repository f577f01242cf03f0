#include "frontend/points/cell_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>

namespace gmcr::frontend {
namespace {

struct KeyedPoint {
  std::uint64_t key;
  Index point;
};

/// Bits of the number of a cell along each axis; nullopt where 64 do not hold all three.
std::optional<std::array<int, 3>> widths_of(const Points& cells) {
  constexpr double kMost = 0x1p63;
  const Eigen::Vector3d largest = cells.rowwise().maxCoeff();
  if (!(largest.maxCoeff() < kMost)) return std::nullopt;
  std::array<int, 3> widths{};
  for (int axis = 0; axis < 3; ++axis) {
    widths[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest[axis])));
  }
  if (widths[0] + widths[1] + widths[2] > 64) return std::nullopt;
  return widths;
}

/// Sorts by the lowest `width` bits of the keys, which are all there is; what ties keeps its order.
std::vector<KeyedPoint> sorted_by_key(std::vector<KeyedPoint> keyed, int width) {
  constexpr int kDigit = 11;
  std::vector<KeyedPoint> other(keyed.size());
  for (int shift = 0; shift < width; shift += kDigit) {
    constexpr std::uint64_t kMask = (1 << kDigit) - 1;
    std::array<std::size_t, kMask + 2> starts{};
    for (const KeyedPoint& entry : keyed) ++starts[((entry.key >> shift) & kMask) + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    for (const KeyedPoint& entry : keyed) other[starts[(entry.key >> shift) & kMask]++] = entry;
    keyed.swap(other);
  }
  return keyed;
}

std::vector<Index> order_of(const Points& cells) {
  std::vector<Index> order(static_cast<std::size_t>(cells.cols()));
  const auto widths = widths_of(cells);
  if (!widths) {  // a stray point far away
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index i) { return std::tuple(cells(0, i), cells(1, i), cells(2, i), i); };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    return order;
  }
  const auto [x_width, y_width, z_width] = *widths;
  std::vector<KeyedPoint> keyed(order.size());
  for (Index i = 0; i < cells.cols(); ++i) {
    std::uint64_t key = static_cast<std::uint64_t>(cells(0, i));
    // no shift by all 64 bits: a key that wide has all of them along one axis
    key = (y_width < 64 ? key << y_width : 0) | static_cast<std::uint64_t>(cells(1, i));
    key = (z_width < 64 ? key << z_width : 0) | static_cast<std::uint64_t>(cells(2, i));
    keyed[static_cast<std::size_t>(i)] = {key, i};
  }
  keyed = sorted_by_key(std::move(keyed), x_width + y_width + z_width);
  std::transform(keyed.begin(), keyed.end(), order.begin(),
                 [](const KeyedPoint& entry) { return entry.point; });
  return order;
}

}  // namespace

CellOrder order_by_cell(const PointsRef& points, const Eigen::Vector3d& origin, double edge) {
  const Points cells = ((points.colwise() - origin) / edge).array().floor();
  CellOrder result;
  result.points = order_of(cells);
  std::vector<Index> firsts;
  for (std::size_t k = 0; k < result.points.size(); ++k) {
    const Index point = result.points[k];
    if (k > 0 && cells.col(point) == cells.col(result.points[k - 1])) continue;
    result.starts.push_back(static_cast<Index>(k));
    firsts.push_back(point);
  }
  result.starts.push_back(points.cols());
  result.cells = cells(Eigen::all, firsts);
  return result;
}

}  // namespace gmcr::frontend
