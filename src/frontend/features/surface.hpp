#pragma once

#include <optional>

#include "frontend/features/fpfh.hpp"
#include "frontend/features/stage_clock.hpp"
#include "frontend/points/neighbourhoods.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// A cloud after the voxel grid, with what its features are computed from.
struct Surface {
  Points voxels;           ///< metres
  Points local;            ///< the same in voxels, from the centre of the cloud
  Eigen::Vector3d centre;  ///< metres
  double voxel_size = 0;   ///< metres
  std::optional<Neighbourhoods>
      neighbourhoods;  ///< within the feature radius, where they are known
  Points normals;      ///< of arbitrary sign; 0 where there is none
};

/// Voxel grid, neighbourhoods and normals of a cloud; times go to the stages "voxel" and "normals".
Surface make_surface(const PointsRef& points, double voxel_size, const FrontendOptions& frontend,
                     int num_threads, StageClock& clock);

/// A surface whose voxels and normals are known, as `make_surface` gave them for these points.
Surface known_surface(const PointsRef& points, double voxel_size, Points voxels, Points normals);

/// The normals of the surface turned to the given side.
/// @param side  not `Automatic`.
Points oriented_normals(const Surface& surface, NormalOrientation side,
                        const Eigen::Vector3d& viewpoint);

/// FPFH of the surface with its normals turned to the given side; time goes to "features".
/// @param surface  its neighbourhoods are known.
/// @param side     not `Automatic`.
Features describe(const Surface& surface, NormalOrientation side, const Eigen::Vector3d& viewpoint,
                  int num_threads, StageClock& clock);

}  // namespace gmcr::frontend
