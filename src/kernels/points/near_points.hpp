#pragma once

#include <cstdint>
#include <span>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Coordinates of points, an array each. As many values more as a vector has lanes are read after
/// the last point, and mean nothing.
struct PointColumns {
  static constexpr Index kPadding = 8;

  const double *x, *y, *z;
};

/// Points [begin, end) of the arrays.
struct PointRun {
  std::int32_t begin = 0, end = 0;
};

/// Points that were found, and their squared distances. Room for those of all runs and as many more
/// as a vector has lanes.
struct NearPoints {
  static constexpr Index kSlack = 8;

  std::int64_t* indices;
  double* squared_distances;
};

/// Which points of some runs are nearer to a query than a radius: in the order of the runs.
/// @param query  x, y, z.
/// @return how many. The same bits as the reference on every instruction set, where the squared
///   distance is (x^2 + y^2) + z^2.
/// Cost O(points of the runs).
Index near_points(const PointColumns& points, std::span<const PointRun> runs, const double* query,
                  double squared_radius, NearPoints found);

/// The same, one point after the other: the specification.
Index near_points_reference(const PointColumns& points, std::span<const PointRun> runs,
                            const double* query, double squared_radius, NearPoints found);

/// The point of some runs, which ascend, that is nearest to a query, if it is nearer than a radius.
struct NearestPoint {
  std::int32_t index = -1;  ///< -1: none; of those that tie the smallest
  double squared_distance = 0;
};

/// @param squared_radius  finite.
/// The same as the reference on every instruction set. Cost O(points of the runs).
NearestPoint nearest_point(const PointColumns& points, std::span<const PointRun> runs,
                           const double* query, double squared_radius);

NearestPoint nearest_point_reference(const PointColumns& points, std::span<const PointRun> runs,
                                     const double* query, double squared_radius);

}  // namespace gmcr::kernels
