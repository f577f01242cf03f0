#include "frontend/points/cell_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>

namespace gmcr::frontend {
namespace {

/// A cell and a point in it as one whole number: the cell above, x above y above z.
class Packing {
 public:
  /// @param last  number of the last cell along each axis.
  /// @return nullopt where 64 bits do not hold it.
  static std::optional<Packing> of(const Eigen::Vector3d& last, Index num_points) {
    constexpr double kMost = 0x1p63;
    if (!(last.maxCoeff() < kMost)) return std::nullopt;
    const auto width = [](double value) {
      return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
    };
    Packing packing;
    packing.point_width_ = width(static_cast<double>(num_points));
    packing.y_width_ = width(last.y());
    packing.z_width_ = width(last.z());
    packing.cell_width_ = width(last.x()) + packing.y_width_ + packing.z_width_;
    if (packing.cell_width_ + packing.point_width_ > 64) return std::nullopt;
    return packing;
  }

  /// @param place  of the point, in cells, >= 0: without its fraction it is the cell.
  std::uint64_t packed(const Eigen::Vector3d& place, Index point) const {
    const auto number = [&](int axis) { return static_cast<std::uint64_t>(place[axis]); };
    const std::uint64_t cell = (number(0) << y_width_ | number(1)) << z_width_ | number(2);
    return cell << point_width_ | static_cast<std::uint64_t>(point);
  }

  Index point(std::uint64_t packed) const {
    return static_cast<Index>(packed & lowest(point_width_));
  }
  std::uint64_t cell(std::uint64_t packed) const { return packed >> point_width_; }
  Eigen::Vector3d numbers(std::uint64_t cell) const {
    return {static_cast<double>(cell >> y_width_ >> z_width_),
            static_cast<double>(cell >> z_width_ & lowest(y_width_)),
            static_cast<double>(cell & lowest(z_width_))};
  }

  /// Sorts by cell; points of one cell keep their order.
  void sort(std::vector<std::uint64_t>& packed) const {
    constexpr int kDigit = 11;
    constexpr std::uint64_t kMask = (1 << kDigit) - 1;
    std::vector<std::uint64_t> other(packed.size());
    for (int shift = point_width_; shift < point_width_ + cell_width_; shift += kDigit) {
      std::array<std::size_t, kMask + 2> starts{};
      for (const std::uint64_t value : packed) ++starts[(value >> shift & kMask) + 1];
      std::partial_sum(starts.begin(), starts.end(), starts.begin());
      for (const std::uint64_t value : packed) other[starts[value >> shift & kMask]++] = value;
      packed.swap(other);
    }
  }

 private:
  static std::uint64_t lowest(int width) { return (std::uint64_t{1} << width) - 1; }

  int point_width_ = 0, y_width_ = 0, z_width_ = 0, cell_width_ = 0;
};

CellOrder order_packed(const Packing& packing, const PointsRef& points,
                       const Eigen::Vector3d& origin, double edge) {
  std::vector<std::uint64_t> packed(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) {
    packed[static_cast<std::size_t>(i)] = packing.packed((points.col(i) - origin) / edge, i);
  }
  packing.sort(packed);
  CellOrder result;
  std::vector<std::uint64_t> cells;
  result.points.reserve(packed.size());
  for (const std::uint64_t value : packed) {
    const std::uint64_t cell = packing.cell(value);
    if (cells.empty() || cell != cells.back()) {
      cells.push_back(cell);
      result.starts.push_back(static_cast<Index>(result.points.size()));
    }
    result.points.push_back(packing.point(value));
  }
  result.starts.push_back(points.cols());
  result.cells.resize(3, std::ssize(cells));
  for (Index k = 0; k < std::ssize(cells); ++k) {
    result.cells.col(k) = packing.numbers(cells[static_cast<std::size_t>(k)]);
  }
  return result;
}

/// Where a stray point is far away.
CellOrder order_by_comparison(const PointsRef& points, const Eigen::Vector3d& origin, double edge) {
  const Points cells = ((points.colwise() - origin) / edge).array().floor();
  CellOrder result;
  result.points.resize(static_cast<std::size_t>(points.cols()));
  std::iota(result.points.begin(), result.points.end(), Index{0});
  const auto key = [&](Index i) { return std::tuple(cells(0, i), cells(1, i), cells(2, i), i); };
  std::sort(result.points.begin(), result.points.end(),
            [&](Index a, Index b) { return key(a) < key(b); });
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

}  // namespace

CellOrder order_by_cell(const PointsRef& points, const Eigen::Vector3d& origin, double edge) {
  if (points.cols() == 0) return {{}, {0}, Points(3, 0)};
  const Eigen::Vector3d last = ((points.rowwise().maxCoeff() - origin) / edge).array().floor();
  const std::optional<Packing> packing = Packing::of(last, points.cols());
  return packing ? order_packed(*packing, points, origin, edge)
                 : order_by_comparison(points, origin, edge);
}

}  // namespace gmcr::frontend
