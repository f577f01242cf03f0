#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// The points within a radius of each point of a cloud, itself excluded.
class Neighbourhoods {
 public:
  std::span<const std::int32_t> indices_of(Index i) const {
    const Block& block = block_of(i);
    const auto [begin, end] = block.range(i % kBlock);
    return {block.indices.data() + begin, end - begin};
  }
  std::span<const double> squared_distances_of(Index i) const {
    const Block& block = block_of(i);
    const auto [begin, end] = block.range(i % kBlock);
    return {block.squared_distances.data() + begin, end - begin};
  }

 private:
  friend Neighbourhoods find_neighbourhoods(const PointsRef& points, double radius,
                                            int num_threads);

  static constexpr Index kBlock = 256;  ///< points

  /// Those of a run of points, one after the other.
  struct Block {
    std::vector<std::size_t> ends;
    std::vector<std::int32_t> indices;
    std::vector<double> squared_distances;

    std::pair<std::size_t, std::size_t> range(Index k) const {
      const auto at = static_cast<std::size_t>(k);
      return {at == 0 ? 0 : ends[at - 1], ends[at]};
    }
  };

  const Block& block_of(Index i) const { return blocks_[static_cast<std::size_t>(i / kBlock)]; }

  std::vector<Block> blocks_;
};

/// Neighbourhoods of all points, by a grid of cells of the radius.
///
/// @param points  3 x N, finite, N < 2^31.
/// @param radius  > 0, the unit of the points; a point at exactly this distance is not a neighbour.
/// Order of the neighbours: cell by cell, in a cell ascending.
/// Cost O(N + points of the 27 cells about each point). Deterministic for any thread count.
Neighbourhoods find_neighbourhoods(const PointsRef& points, double radius, int num_threads);

}  // namespace gmcr::frontend
