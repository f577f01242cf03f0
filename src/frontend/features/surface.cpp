#include "frontend/features/surface.hpp"

#include <utility>

#include "frontend/features/normals.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

namespace {

/// Voxels of the points, and where they lie.
Surface surface_of(const PointsRef& points, double voxel_size, Points voxels) {
  Surface surface;
  surface.voxel_size = voxel_size;
  surface.voxels = std::move(voxels);
  surface.centre = Eigen::Vector3d::Zero();
  if (points.cols() > 0) {
    surface.centre = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  }
  // in voxels and near 0 every radius is a plain number and no digit is lost
  surface.local = (surface.voxels.colwise() - surface.centre) / voxel_size;
  return surface;
}

}  // namespace

Surface make_surface(const PointsRef& points, double voxel_size, const FrontendOptions& frontend,
                     int num_threads, StageClock& clock) {
  Surface surface = surface_of(points, voxel_size, voxel_grid(points, voxel_size));
  clock.lap("voxel");
  surface.neighbourhoods = find_neighbourhoods(surface.local, frontend.feature_radius, num_threads);
  surface.normals =
      estimate_normals(surface.local, *surface.neighbourhoods, frontend.normal_radius, num_threads);
  clock.lap("normals");
  return surface;
}

Surface known_surface(const PointsRef& points, double voxel_size, Points voxels, Points normals) {
  Surface surface = surface_of(points, voxel_size, std::move(voxels));
  surface.normals = std::move(normals);
  return surface;
}

Points oriented_normals(const Surface& surface, NormalOrientation side,
                        const Eigen::Vector3d& viewpoint) {
  if (side == NormalOrientation::Outward) return orient_outward(surface.local, surface.normals);
  return orient_toward(surface.local, surface.normals,
                       (viewpoint - surface.centre) / surface.voxel_size);
}

Features describe(const Surface& surface, NormalOrientation side, const Eigen::Vector3d& viewpoint,
                  int num_threads, StageClock& clock) {
  const Points normals = oriented_normals(surface, side, viewpoint);
  Features features = compute_fpfh(surface.local, normals, *surface.neighbourhoods, num_threads);
  clock.lap("features");
  return features;
}

}  // namespace gmcr::frontend
