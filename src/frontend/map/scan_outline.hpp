#pragma once

#include <vector>

#include "frontend/map/level_frame.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// A place beside the sensor, level with its ground, in voxels.
struct OutlinePoint {
  double x, y;
  int band;  ///< of `StructureGrid`
};

/// A scan as `StructureGrid` sees it: what stands around the sensor.
struct ScanOutline {
  std::vector<OutlinePoint> structure;  ///< one a cell and band, from near to far
  /// Turns the scan so that its ground is level.
  Eigen::Matrix3d level_from_scan = Eigen::Matrix3d::Identity();
  double sensor_height = 0;  ///< voxels above the ground
};

/// @param voxels  3 x N, in voxels, about the sensor, in the axes of the scan.
/// @param up      in these axes, unit.
ScanOutline outline_of(const Points& voxels, const Eigen::Vector3d& up);

}  // namespace gmcr::frontend
