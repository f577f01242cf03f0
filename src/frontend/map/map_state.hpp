#pragma once

#include <memory>

#include "frontend/alignment/surface_cloud.hpp"
#include "frontend/map/place_search.hpp"
#include "frontend/map/structure_grid.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// What a prepared map holds.
struct MapState {
  /// @param fine_voxels  metres, at least one, on voxels of half the size.
  /// @param given        how many points they were made of.
  /// @param upward       unit.
  MapState(Points fine_voxels, Index given, double voxel, const Eigen::Vector3d& upward,
           int num_threads);

  /// A place as a pose of the scan: between the caller's frames.
  /// @param viewpoint  of the sensor, metres, scan frame.
  Similarity pose_at(const Place& place, const ScanOutline& outline,
                     const Eigen::Vector3d& viewpoint, double scale) const;

  /// Where a point lies, level, in voxels about the centre.
  Eigen::Vector3d level(const Eigen::Vector3d& point) const;

  Points fine;        ///< metres
  Index num_given;    ///< points of the map before they were put on voxels
  double voxel_size;  ///< metres
  Eigen::Vector3d up;
  Points voxels;                          ///< metres
  Eigen::Vector3d centre;                 ///< metres: of the voxels
  Eigen::Matrix3d level_from_map;         ///< about the centre
  std::shared_ptr<SurfaceCloud> surface;  ///< the voxels, with all normals
  StructureGrid grid;
  PlaceSearch places;
};

}  // namespace gmcr::frontend
