#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "frontend/points/cell_order.hpp"
#include "gmcr/types.hpp"
#include "kernels/points/near_points.hpp"

namespace gmcr::frontend {

/// Points sorted into cubic cells, for searches within a radius about any position.
///
/// Where the cells of the bounding box are not many more than the points, each knows its first
/// point. Else every cell next to an occupied one knows the runs of points about it, in a table
/// that keeps no cell for empty space.
class PointGrid {
 public:
  /// @param points  3 x N, finite, N < 2^31.
  /// @param reach   > 0: the largest radius that will be sought, the unit of the points.
  /// Cost O(N), and 27 times the occupied cells for a table.
  PointGrid(const PointsRef& points, double reach);

  double reach() const { return reach_; }

  /// The 3 x 3 columns of cells about one; in each, three cells that follow one another.
  using Runs = std::array<kernels::PointRun, 9>;

  /// Runs of slots with all points nearer than the reach to a position, and others; ascending.
  /// @param room  for the runs that are returned.
  std::span<const kernels::PointRun> runs_about(const double* position, Runs& room) const;

  /// The same for a radius up to the reach: those of them that it meets.
  std::span<const kernels::PointRun> runs_within(const double* position, double radius,
                                                 Runs& room) const;

  /// How many points these have.
  static Index num_points(std::span<const kernels::PointRun> runs);

  /// Coordinates by slot.
  kernels::PointColumns columns() const {
    return {sorted_.col(0).data(), sorted_.col(1).data(), sorted_.col(2).data()};
  }
  /// The point of a slot.
  Index point(std::int64_t slot) const { return order_[static_cast<std::size_t>(slot)]; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell{};
    std::int32_t runs = -1;  ///< -1: free
  };

  Cell cell_at(const double* position) const;
  bool number_box(const CellOrder& order);
  kernels::PointRun run_in_box(std::int64_t x, std::int64_t y, std::int64_t z) const;
  void fill_table(const CellOrder& order);
  std::size_t slot_of(const Cell& cell) const;
  Runs& runs_at(const Cell& cell);
  void grow();

  double reach_;
  double edge_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<Index> order_;
  Eigen::MatrixX3d sorted_;  ///< coordinates by slot, and the padding that kernels read
  Cell box_{};               ///< cells along each axis
  /// First slot in or after each cell of the box, x slowest; empty: there is a table.
  std::vector<std::int32_t> first_;
  std::vector<Entry> table_;  ///< open addressing, a power of two
  std::vector<Runs> runs_;
};

}  // namespace gmcr::frontend
