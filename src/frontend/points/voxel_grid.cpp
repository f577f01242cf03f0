#include <sstream>
#include <stdexcept>

#include "frontend/points/cell_order.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr {
namespace {

/// @throws std::invalid_argument where an axis has more cells than 63 bits can number.
void require_countable(const Eigen::Vector3d& extent, double voxel_size) {
  constexpr double kMostCells = 9.2e18;
  if (extent.maxCoeff() / voxel_size < kMostCells) return;
  std::ostringstream message;
  message << "voxel_size: " << voxel_size << " is too small for a cloud that spans "
          << extent.maxCoeff();
  throw std::invalid_argument(message.str());
}

}  // namespace

Points voxel_grid(const PointsRef& points, double voxel_size) {
  if (points.cols() == 0) return Points(3, 0);
  const Eigen::Vector3d origin = points.rowwise().minCoeff();
  const Eigen::Vector3d extent = points.rowwise().maxCoeff() - origin;
  require_countable(extent, voxel_size);
  const frontend::CellOrder order = frontend::order_by_cell(points, origin, voxel_size);
  Points means(3, order.num_cells());
  for (Index cell = 0; cell < order.num_cells(); ++cell) {
    const auto first = static_cast<std::size_t>(order.starts[static_cast<std::size_t>(cell)]);
    const auto last = static_cast<std::size_t>(order.starts[static_cast<std::size_t>(cell) + 1]);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // relative to the origin: no loss far from 0
    for (std::size_t k = first; k < last; ++k) sum += points.col(order.points[k]) - origin;
    means.col(cell) = origin + sum / static_cast<double>(last - first);
  }
  return means;
}

}  // namespace gmcr
