#include "frontend/points/point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "frontend/points/cell_order.hpp"

namespace gmcr::frontend {
namespace {

/// Cells are wider than the reach by more than what rounding moves a point.
constexpr double kMargin = 1 + 1e-6;
/// The same, in cells, of a position that is fewer than so many cells off.
constexpr double kPlaceMargin = 1e-9, kExactCells = 1e6;
/// Number of the last cell: what lies beyond shares it.
constexpr double kMostCells = 0x1p62;

std::int64_t number_of(double cell) {
  return static_cast<std::int64_t>(std::max(-kMostCells, std::min(cell, kMostCells)));
}

}  // namespace

PointGrid::PointGrid(const PointsRef& points, double reach)
    : reach_(reach), edge_(kMargin * reach) {
  if (points.cols() == 0) return;
  origin_ = points.rowwise().minCoeff();
  CellOrder order = order_by_cell(points, origin_, edge_);
  sorted_.setZero(points.cols() + kernels::PointColumns::kPadding, 3);
  sorted_.topRows(points.cols()) = points(Eigen::all, order.points).transpose();
  if (!number_box(order)) fill_table(order);
  order_ = std::move(order.points);
}

/// @return false where it has too many cells.
bool PointGrid::number_box(const CellOrder& order) {
  constexpr double kMostCellsAPoint = 16;
  const Eigen::Vector3d box = order.cells.rowwise().maxCoeff().array() + 1;
  if (!(box.prod() <= kMostCellsAPoint * static_cast<double>(order.points.size()))) return false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    box_[axis] = number_of(box[static_cast<Index>(axis)]);
  const auto num_cells = static_cast<std::size_t>(box_[0] * box_[1] * box_[2]);
  first_.reserve(num_cells + 1);
  for (Index k = 0; k < order.num_cells(); ++k) {
    const auto [x, y, z] = std::array{number_of(order.cells(0, k)), number_of(order.cells(1, k)),
                                      number_of(order.cells(2, k))};
    const auto begin = static_cast<std::int32_t>(order.starts[static_cast<std::size_t>(k)]);
    first_.resize(static_cast<std::size_t>((x * box_[1] + y) * box_[2] + z) + 1, begin);
  }
  first_.resize(num_cells + 1, static_cast<std::int32_t>(order.points.size()));
  return true;
}

/// The points of the three cells at z - 1, z and z + 1 of a column.
kernels::PointRun PointGrid::run_in_box(std::int64_t x, std::int64_t y, std::int64_t z) const {
  const std::int64_t low = std::max<std::int64_t>(z - 1, 0), high = std::min(z + 2, box_[2]);
  if (x < 0 || x >= box_[0] || y < 0 || y >= box_[1] || low >= high) return {};
  const std::int64_t column = (x * box_[1] + y) * box_[2];
  return {first_[static_cast<std::size_t>(column + low)],
          first_[static_cast<std::size_t>(column + high)]};
}

void PointGrid::fill_table(const CellOrder& order) {
  table_.resize(64);
  for (Index k = 0; k < order.num_cells(); ++k) {
    const auto begin = static_cast<std::int32_t>(order.starts[static_cast<std::size_t>(k)]);
    const auto end = static_cast<std::int32_t>(order.starts[static_cast<std::size_t>(k) + 1]);
    const Eigen::Vector3d cell = order.cells.col(k);
    const Cell own{number_of(cell.x()), number_of(cell.y()), number_of(cell.z())};
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          // cells come in order, so what a column has already ends where this cell starts
          kernels::PointRun& run =
              runs_at({own[0] - dx, own[1] - dy,
                       own[2] - dz})[static_cast<std::size_t>(3 * (dx + 1) + dy + 1)];
          if (run.end == 0) run.begin = begin;
          run.end = end;
        }
      }
    }
  }
}

PointGrid::Cell PointGrid::cell_at(const double* position) const {
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cell[axis] =
        number_of(std::floor((position[axis] - origin_[static_cast<Index>(axis)]) / edge_));
  }
  return cell;
}

std::size_t PointGrid::slot_of(const Cell& cell) const {
  const auto [x, y, z] = cell;
  // whole numbers that follow one another fall apart in the upper half of the product
  const std::uint64_t mixed =
      (static_cast<std::uint64_t>(x) * 0x8da6b343 ^ static_cast<std::uint64_t>(y) * 0xd8163841 ^
       static_cast<std::uint64_t>(z) * 0xcb1ab31f) *
      0x9e3779b97f4a7c15;
  std::size_t slot = (mixed >> 32) & (table_.size() - 1);
  const auto is_other = [&cell](const Entry& entry) {  // of arrays, != calls memcmp
    return entry.runs >= 0 &&
           (entry.cell[0] != cell[0] || entry.cell[1] != cell[1] || entry.cell[2] != cell[2]);
  };
  while (is_other(table_[slot])) slot = (slot + 1) & (table_.size() - 1);
  return slot;
}

PointGrid::Runs& PointGrid::runs_at(const Cell& cell) {
  std::size_t slot = slot_of(cell);
  if (table_[slot].runs < 0) {
    if (2 * (runs_.size() + 1) > table_.size()) {
      grow();
      slot = slot_of(cell);
    }
    table_[slot] = {cell, static_cast<std::int32_t>(runs_.size())};
    runs_.emplace_back();
  }
  return runs_[static_cast<std::size_t>(table_[slot].runs)];
}

void PointGrid::grow() {
  const std::vector<Entry> before = std::exchange(table_, std::vector<Entry>(4 * table_.size()));
  for (const Entry& entry : before) {
    if (entry.runs >= 0) table_[slot_of(entry.cell)] = entry;
  }
}

std::span<const kernels::PointRun> PointGrid::runs_about(const double* position, Runs& room) const {
  const Cell cell = cell_at(position);
  if (first_.empty()) {
    if (table_.empty()) return {};
    const Entry& entry = table_[slot_of(cell)];
    if (entry.runs < 0) return {};
    return runs_[static_cast<std::size_t>(entry.runs)];
  }
  for (std::int64_t column = 0; column < 9; ++column) {
    room[static_cast<std::size_t>(column)] =
        run_in_box(cell[0] + column / 3 - 1, cell[1] + column % 3 - 1, cell[2]);
  }
  return room;
}

std::span<const kernels::PointRun> PointGrid::runs_within(const double* position, double radius,
                                                          Runs& room) const {
  const std::span<const kernels::PointRun> about = runs_about(position, room);
  // squared distances, in cells, to the columns before, at and after the own one, along x and y
  std::array<std::array<double, 3>, 2> gaps{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double place = (position[axis] - origin_[static_cast<Index>(axis)]) / edge_;
    if (!(std::abs(place) < kExactCells)) return about;
    const double inside = place - std::floor(place);
    gaps[axis] = {inside * inside, 0, (1 - inside) * (1 - inside)};
  }
  const double reached = radius / reach_ + kPlaceMargin;
  std::size_t count = 0;
  for (std::size_t k = 0; k < about.size(); ++k) {
    if (about[k].begin == about[k].end) continue;
    if (gaps[0][k / 3] + gaps[1][k % 3] <= reached * reached) room[count++] = about[k];
  }
  return {room.data(), count};
}

Index PointGrid::num_points(std::span<const kernels::PointRun> runs) {
  Index count = 0;
  for (const kernels::PointRun& run : runs) count += run.end - run.begin;
  return count;
}

}  // namespace gmcr::frontend
