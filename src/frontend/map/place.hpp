#pragma once

#include <functional>

namespace gmcr::frontend {

/// Where the sensor may have stood, level, in voxels about the centre of the map.
struct Place {
  double x = 0, y = 0;
  double ground = 0;   ///< height there
  double heading = 0;  ///< radians: the level scan is turned by it about z
};

/// Which places are looked at; null: all.
struct PlaceLimits {
  std::function<bool(double x, double y)> position;
  std::function<bool(double heading)> heading;
};

}  // namespace gmcr::frontend
