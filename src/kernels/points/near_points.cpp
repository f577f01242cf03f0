#include "kernels/points/near_points.hpp"

namespace gmcr::kernels {
namespace {

double squared_distance(const PointColumns& points, std::int32_t i, const double* query) {
  const double dx = points.x[i] - query[0];
  const double dy = points.y[i] - query[1];
  const double dz = points.z[i] - query[2];
  return (dx * dx + dy * dy) + dz * dz;
}

}  // namespace

Index near_points_reference(const PointColumns& points, std::span<const PointRun> runs,
                            const double* query, double squared_radius, NearPoints found) {
  Index count = 0;
  for (const PointRun& run : runs) {
    for (std::int32_t i = run.begin; i < run.end; ++i) {
      const double squared = squared_distance(points, i, query);
      found.indices[count] = i;
      found.squared_distances[count] = squared;
      count += squared < squared_radius;
    }
  }
  return count;
}

NearestPoint nearest_point_reference(const PointColumns& points, std::span<const PointRun> runs,
                                     const double* query, double squared_radius) {
  NearestPoint nearest{-1, squared_radius};
  for (const PointRun& run : runs) {
    for (std::int32_t i = run.begin; i < run.end; ++i) {
      const double squared = squared_distance(points, i, query);
      if (squared < nearest.squared_distance) nearest = {i, squared};
    }
  }
  return nearest;
}

}  // namespace gmcr::kernels
