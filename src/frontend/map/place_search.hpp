#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "frontend/map/place.hpp"
#include "frontend/map/scan_outline.hpp"
#include "frontend/map/structure_grid.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// All places of a map: positions four voxels and headings three degrees apart.
class PlaceSearch {
 public:
  /// Cost O(cells).
  explicit PlaceSearch(const StructureGrid& grid);

  /// The places at which most of the outline is met, distinct, best first; ties by heading and
  /// position.
  /// @param most  places, at most.
  /// Cost O(admitted places); a sum of bytes a place and point of the outline. Deterministic for
  /// any thread count; where the deadline ends it, of some of the headings.
  std::vector<Place> best(const ScanOutline& outline, std::size_t most, const PlaceLimits& limits,
                          int num_threads, const parallel::Deadline& deadline) const;

  /// How far a place may be from the nearest one that is looked at, voxels along an axis, and
  /// radians.
  static double half_step();
  static double half_turn();

 private:
  /// Positions side by side.
  struct Run {
    Index cell;  ///< the first
    Index length;
    Index number;  ///< of the first among all positions
  };
  /// A place by its numbers.
  struct Found {
    int score;
    Index heading;
    Index cell;
  };

  void find_positions(const StructureGrid& grid, const std::vector<char>& is_ground);
  std::vector<Run> admitted_runs(const PlaceLimits& limits) const;
  /// Writes to `sums`, a byte a position, how many of the points are met there.
  void count_met(const std::vector<OutlinePoint>& points, double heading,
                 const std::vector<Run>& runs, std::uint8_t* sums) const;
  std::vector<Found> distinct(std::vector<Found> found, std::size_t most) const;
  Place place_of(const Found& found) const;

  Index width_ = 0, height_ = 0;  ///< cells of two by two of the grid
  Eigen::Vector2d origin_;        ///< voxels
  std::array<std::vector<std::uint8_t>, StructureGrid::kNumBands> met_;  ///< 0 or 1 a cell
  std::vector<float> ground_;                                            ///< voxels
  std::vector<Index> positions_;                                         ///< cells, ascending
};

}  // namespace gmcr::frontend
