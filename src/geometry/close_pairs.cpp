#include "geometry/close_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace gmcr::geometry {
namespace {

using Visit = std::function<bool(Index, Index, double)>;

/// Cells are numbered so that those along z follow each other, and rows of cells lie a fixed number
/// apart.
constexpr int kBitsPerAxis = 21;
constexpr std::int64_t kNextY = std::int64_t{1} << kBitsPerAxis;
constexpr std::int64_t kNextX = std::int64_t{1} << (2 * kBitsPerAxis);

/// The rows of three cells around a cell, as offsets of their middle.
constexpr std::int64_t kOwnRow[] = {0};
constexpr std::int64_t kLaterRows[] = {kNextY, kNextX - kNextY, kNextX, kNextX + kNextY};
constexpr std::int64_t kAllRows[] = {-kNextX - kNextY, -kNextX, -kNextX + kNextY,
                                     -kNextY,          0,       kNextY,
                                     kNextX - kNextY,  kNextX,  kNextX + kNextY};

struct CellPoint {
  std::int64_t cell;
  Index index;
  Eigen::Vector3d point;
  double radius;
};

/// A grid over all of the points.
class Grid {
 public:
  /// @param width  of the cells, at least.
  Grid(const PointsRef& points, const Eigen::ArrayXd& radii, double width)
      : points_(points), radii_(radii), origin_(points.rowwise().minCoeff()) {
    constexpr double kRounding = 1e-9;
    double extent = (points.rowwise().maxCoeff() - origin_).maxCoeff();
    if (extent > width * kMaxCells) extent = leave_out_far_points();
    per_width_ = 1 / (std::max(width, extent / kMaxCells) * (1 + kRounding));
  }

  /// The points with the given indices, by cell.
  std::vector<CellPoint> sort(const std::vector<Index>& indices) const {
    std::vector<CellPoint> sorted;
    sorted.reserve(indices.size());
    for (const Index i : indices) {
      const Eigen::Vector3d place = (points_.col(i) - origin_) * per_width_;
      // those outside join the outermost cells, in which neighbours stay neighbours
      const auto along = [&](Index axis) {
        return static_cast<std::int64_t>(std::clamp(place[axis], 0.0, kMaxCells)) + 1;
      };
      sorted.push_back(
          {along(0) * kNextX + along(1) * kNextY + along(2), i, points_.col(i), radii_[i]});
    }
    std::sort(sorted.begin(), sorted.end(), [](const CellPoint& a, const CellPoint& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.index < b.index;
    });
    return sorted;
  }

 private:
  static constexpr double kMaxCells = 1 << (kBitsPerAxis - 1);

  /// Moves the origin so that the grid covers all but few of the points, which alone would make its
  /// cells so large that they hold all the others. @return its extent.
  double leave_out_far_points() {
    const Index n = points_.cols();
    const auto few = static_cast<Index>(std::sqrt(static_cast<double>(n)));
    double extent = 0;
    for (Index axis = 0; axis < 3; ++axis) {
      const Eigen::VectorXd row = points_.row(axis);
      std::vector<double> sorted(row.begin(), row.end());
      const auto low = sorted.begin() + std::min(few, (n - 1) / 2);
      const auto high = sorted.begin() + std::max(n - 1 - few, n / 2);
      std::nth_element(sorted.begin(), low, sorted.end());
      std::nth_element(low, high, sorted.end());
      origin_[axis] = *low;
      extent = std::max(extent, *high - *low);
    }
    return extent;
  }

  const PointsRef& points_;
  const Eigen::ArrayXd& radii_;
  Eigen::Vector3d origin_;
  double per_width_;
};

bool visit_pair(const CellPoint& a, const CellPoint& b, const Visit& visit) {
  const double squared = (b.point - a.point).squaredNorm();
  const double radius = 2 * std::min(a.radius, b.radius);
  return squared > radius * radius || visit(a.index, b.index, radius);
}

/// Visits the pairs of one of `from` and one of `to` in the row of cells at an offset from it.
/// @param after_itself  `from` and `to` are the same: only those behind the first.
bool visit_row(const std::vector<CellPoint>& from, const std::vector<CellPoint>& to,
               std::int64_t offset, bool after_itself, const Visit& visit) {
  std::size_t begin = 0;  // cells ascend, and so do the rows seen from them
  for (std::size_t p = 0; p < from.size(); ++p) {
    const std::int64_t middle = from[p].cell + offset;
    while (begin < to.size() && to[begin].cell < middle - 1) ++begin;
    for (std::size_t q = after_itself ? p + 1 : begin; q < to.size() && to[q].cell <= middle + 1;
         ++q) {
      if (!visit_pair(from[p], to[q], visit)) return false;
    }
  }
  return true;
}

bool visit_rows(const std::vector<CellPoint>& from, const std::vector<CellPoint>& to,
                std::span<const std::int64_t> offsets, bool after_itself, const Visit& visit) {
  return std::all_of(offsets.begin(), offsets.end(), [&](std::int64_t offset) {
    return visit_row(from, to, offset, after_itself, visit);
  });
}

}  // namespace

bool for_each_close_pair(const PointsRef& points, const Eigen::ArrayXd& radii, const Visit& visit) {
  std::map<int, std::vector<Index>> by_radius;  // of one power of two each
  for (Index i = 0; i < points.cols(); ++i) by_radius[std::ilogb(radii[i])].push_back(i);
  std::vector<Index> longer;  // no pair is farther apart than the shorter radius allows
  for (auto group = by_radius.rbegin(); group != by_radius.rend(); ++group) {
    const std::vector<Index>& indices = group->second;
    double longest = 0;
    for (const Index i : indices) longest = std::max(longest, radii[i]);
    const Grid grid(points, radii, 2 * longest);
    const std::vector<CellPoint> cells = grid.sort(indices);
    if (!visit_rows(cells, cells, kOwnRow, true, visit) ||
        !visit_rows(cells, cells, kLaterRows, false, visit)) {
      return false;
    }
    if (!longer.empty() && !visit_rows(cells, grid.sort(longer), kAllRows, false, visit)) {
      return false;
    }
    longer.insert(longer.end(), indices.begin(), indices.end());
  }
  return true;
}

}  // namespace gmcr::geometry
