#include "frontend/features/normals.hpp"

#include "geometry/plane_normal.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

Eigen::Vector3d estimate_normal(const PointsRef& points, const Neighbourhoods& neighbourhoods,
                                double squared_radius, Index i) {
  const auto indices = neighbourhoods.indices_of(i);
  const auto squared_distances = neighbourhoods.squared_distances_of(i);
  // offsets from the point itself, which is one of the samples, keep the sums small
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  double count = 1;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (squared_distances[k] >= squared_radius) continue;
    const Eigen::Vector3d offset = points.col(indices[k]) - points.col(i);
    sum += offset;
    outer += offset * offset.transpose();
    ++count;
  }
  if (count < 3) return Eigen::Vector3d::Zero();
  return geometry::plane_normal(outer / count - sum * sum.transpose() / (count * count));
}

}  // namespace

Points estimate_normals(const PointsRef& points, const Neighbourhoods& neighbourhoods,
                        double radius, int num_threads) {
  Points normals(3, points.cols());
  parallel::parallel_for(points.cols(), 256, num_threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      normals.col(i) = estimate_normal(points, neighbourhoods, radius * radius, i);
    }
  });
  return normals;
}

Points orient_toward(const PointsRef& points, const Points& normals,
                     const Eigen::Vector3d& viewpoint) {
  Points oriented = normals;
  for (Index i = 0; i < points.cols(); ++i) {
    if (normals.col(i).dot(viewpoint - points.col(i)) < 0) oriented.col(i) = -normals.col(i);
  }
  return oriented;
}

Points orient_outward(const PointsRef& points, const Points& normals) {
  if (points.cols() == 0) return normals;
  return -orient_toward(points, normals, points.rowwise().mean());
}

}  // namespace gmcr::frontend
