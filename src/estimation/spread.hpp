#pragma once

#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// How far chosen points are from their centroid and from the line through it that fits them
/// best.
struct Spread {
  double from_centroid = 0;  ///< metres; 0: all points coincide
  double from_line = 0;      ///< metres; 0: all points are on one line
};

/// Cost O(number of indices). An empty set has no spread.
Spread measure_spread(const PointsRef& points, const std::vector<Index>& indices);

/// Longest distance of the points from the line along `direction` through their centroid, metres.
double distance_from_line(const PointsRef& points, const std::vector<Index>& indices,
                          const Eigen::Vector3d& direction);

}  // namespace gmcr::estimation
