#pragma once

#include <cstdint>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "synthetic/town/ray_caster.hpp"

namespace gmcr::synthetic {

/// A rotating scanner; angles in degrees.
struct Lidar {
  int num_rings = 64;
  double lowest = -24.9, highest = 2;  ///< rings, above the horizon
  int num_columns = 1800;              ///< a turn
  double range = 100;                  ///< metres
  double noise = 0.02;                 ///< metres, along the ray
};

/// The usual scanners of 16, 32 and 64 rings.
/// @throws std::invalid_argument on another number.
Lidar lidar_of(int num_rings);

/// What the scanner sees, in its frame.
/// @param town_from_sensor  its scale is 1.
Points scan(const RayCaster& caster, const Similarity& town_from_sensor, const Lidar& lidar,
            std::uint64_t seed);

/// A scanner on a car at a place: 1.8 m above the ground, inclined by up to so many degrees.
Similarity sensor_at(const TownPlace& place, double max_tilt_deg, Random& random);

/// The map that a drive along all streets leaves: scans of 64 rings, one after the other on a grid
/// of voxels.
/// @param step   metres between two scans.
/// @param voxel  metres: of the points of the map.
Points map_of(const Town& town, double step, double voxel, std::uint64_t seed);

}  // namespace gmcr::synthetic
