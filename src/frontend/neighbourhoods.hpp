#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// The points within a radius of each point of a cloud, itself excluded.
///
/// Stored one after the other: those of point i are at [offsets[i], offsets[i + 1]).
struct Neighbourhoods {
  std::vector<std::size_t> offsets;  ///< N + 1
  std::vector<std::int32_t> indices;
  std::vector<double> squared_distances;

  std::span<const std::int32_t> indices_of(Index i) const {
    return {indices.data() + begin(i), begin(i + 1) - begin(i)};
  }
  std::span<const double> squared_distances_of(Index i) const {
    return {squared_distances.data() + begin(i), begin(i + 1) - begin(i)};
  }

 private:
  std::size_t begin(Index i) const { return offsets[static_cast<std::size_t>(i)]; }
};

/// Neighbourhoods of all points, by a k-d tree.
///
/// @param points  3 x N, finite, N < 2^31.
/// @param radius  > 0, the unit of the points; a point at exactly this distance is not a neighbour.
/// Order of the neighbours: that of the tree, the same in every run.
/// Cost O(N log N + number of neighbours). Deterministic for any thread count.
Neighbourhoods find_neighbourhoods(const PointsRef& points, double radius, int num_threads);

}  // namespace gmcr::frontend
