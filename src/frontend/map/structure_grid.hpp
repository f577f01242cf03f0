#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// What stands on the ground: cells of two voxels seen from above, and in each a bit for every band
/// of heights above the ground beside it that something reaches into.
class StructureGrid {
 public:
  static constexpr double kCell = 2;           ///< voxels
  static constexpr double kBand = 3;           ///< voxels
  static constexpr double kLeastHeight = 1.5;  ///< voxels above the ground: below, it is ground
  static constexpr int kNumBands = 8;
  static constexpr Index kMargin = 64;  ///< cells of nothing around it: how far a scan is looked at

  StructureGrid() = default;

  /// @param voxels  3 x N, level, in voxels.
  /// @throws std::invalid_argument where they spread too wide.
  explicit StructureGrid(const Points& voxels);

  /// Band of a height above the ground; -1: the ground itself.
  static int band(double height);

  Index width() const { return width_; }
  Index height() const { return height_; }
  const Eigen::Vector2d& origin() const { return origin_; }  ///< voxels: of cell (0, 0)

  /// Bits of a cell and of those beside it.
  std::uint8_t near(Index cell) const { return near_[static_cast<std::size_t>(cell)]; }
  /// Height of the ground about a cell, voxels; infinity where none is known.
  float ground(Index cell) const { return ground_[static_cast<std::size_t>(cell)]; }
  /// Whether the ground itself was seen in the cell.
  bool is_ground(Index cell) const { return is_ground_[static_cast<std::size_t>(cell)]; }

 private:
  void lay_out(const Points& voxels);
  void find_ground(const Points& voxels);
  void mark(const Points& voxels);
  Index cell_of(double x, double y) const;  ///< -1: outside

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Index width_ = 0, height_ = 0;
  std::vector<float> ground_;
  std::vector<char> is_ground_;
  std::vector<std::uint8_t> near_;
};

}  // namespace gmcr::frontend
