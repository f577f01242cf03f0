#pragma once

#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// Points in the order of the cubic cells that they lie in.
struct CellOrder {
  std::vector<Index> points;  ///< N, cell by cell: x slowest, z fastest; ascending in a cell
  std::vector<Index> starts;  ///< where each occupied cell starts, and N
  Points cells;               ///< 3 x occupied cells: their numbers along the axes, whole and >= 0

  Index num_cells() const { return cells.cols(); }
};

/// Sorts points by the cells of a grid that starts at `origin`.
/// @param points  3 x N, finite.
/// @param origin  at most the smallest coordinates.
/// @param edge    of a cell, > 0, the unit of the points.
/// Cost O(N) where the cells of the bounding box can be numbered with 64 bits, else O(N log N).
CellOrder order_by_cell(const PointsRef& points, const Eigen::Vector3d& origin, double edge);

}  // namespace gmcr::frontend
