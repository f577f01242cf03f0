#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// How far chosen points are from their centroid and from the line through it that fits them best,
/// each weighing 1 over its squared bound: a loose point moves neither away from tight ones.
struct Spread {
  Eigen::ArrayXd from_centroid;  ///< of each, metres; all 0: the points coincide
  Eigen::ArrayXd from_line;      ///< of each, metres; all 0: they are on one line
  double radius = 0;             ///< weighted RMS of `from_centroid`
};

/// @param bounds  of the chosen points, metres, > 0.
/// Cost O(number of indices). An empty set has an empty spread.
Spread measure_spread(const PointsRef& points, const std::vector<Index>& indices,
                      const Eigen::ArrayXd& bounds);

/// Distance of each of the points from the line along `direction` through their centroid, metres.
Eigen::ArrayXd distances_from_line(const PointsRef& points, const std::vector<Index>& indices,
                                   const Eigen::ArrayXd& bounds, const Eigen::Vector3d& direction);

}  // namespace gmcr::estimation
