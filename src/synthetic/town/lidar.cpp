#include "synthetic/town/lidar.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::synthetic {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMountHeight = 1.8;  // metres

}  // namespace

Lidar lidar_of(int num_rings) {
  Lidar lidar;
  lidar.num_rings = num_rings;
  if (num_rings == 16) {
    lidar.lowest = -15, lidar.highest = 15;
  } else if (num_rings == 32) {
    lidar.lowest = -30.67, lidar.highest = 10.67;
  } else if (num_rings != 64) {
    throw std::invalid_argument("num_rings: " + std::to_string(num_rings));
  }
  return lidar;
}

Points scan(const RayCaster& caster, const Similarity& town_from_sensor, const Lidar& lidar,
            std::uint64_t seed) {
  Random random(seed);
  Points points(3, static_cast<Index>(lidar.num_rings) * lidar.num_columns);
  Index count = 0;
  for (int ring = 0; ring < lidar.num_rings; ++ring) {
    const double share = lidar.num_rings > 1 ? ring / (lidar.num_rings - 1.0) : 0;
    const double elevation = kDegree * (lidar.lowest + share * (lidar.highest - lidar.lowest));
    for (int column = 0; column < lidar.num_columns; ++column) {
      const double azimuth = 2 * std::numbers::pi * column / lidar.num_columns;
      const Eigen::Vector3d ray(elementary::cos(elevation) * elementary::cos(azimuth),
                                elementary::cos(elevation) * elementary::sin(azimuth),
                                elementary::sin(elevation));
      const double distance = caster.distance(town_from_sensor.translation,
                                              town_from_sensor.rotation * ray, lidar.range);
      const double noise = lidar.noise * random.normal();
      if (distance < lidar.range) points.col(count++) = (distance + noise) * ray;
    }
  }
  return points.leftCols(count);
}

Similarity sensor_at(const TownPlace& place, double max_tilt_deg, Random& random) {
  const double tilt = kDegree * max_tilt_deg;
  Similarity pose;
  const double roll = random.uniform(-tilt, tilt), pitch = random.uniform(-tilt, tilt);
  pose.rotation = geometry::turn_about(Eigen::Vector3d::UnitZ(), place.heading) *
                  geometry::turn_about(Eigen::Vector3d::UnitY(), pitch) *
                  geometry::turn_about(Eigen::Vector3d::UnitX(), roll);
  pose.translation = {place.position.x(), place.position.y(), kMountHeight};
  return pose;
}

Points map_of(const Town& town, double step, double voxel, std::uint64_t seed) {
  const RayCaster caster(town);
  Random random(seed);
  // the first point of each voxel, by its number
  std::unordered_map<std::uint64_t, bool> taken;
  std::vector<Eigen::Vector3d> kept;
  constexpr double kOffset = 1 << 20;
  for (const TownPlace& place : drive(town, step)) {
    const Similarity pose = sensor_at(place, 1, random);
    const Points seen = pose.apply(scan(caster, pose, lidar_of(64), seed + 1 + kept.size()));
    for (Index i = 0; i < seen.cols(); ++i) {
      std::uint64_t number = 0;
      for (int axis = 0; axis < 3; ++axis) {
        number = (number << 21) |
                 static_cast<std::uint64_t>(std::floor(seen(axis, i) / voxel) + kOffset);
      }
      if (taken.emplace(number, true).second) kept.push_back(seen.col(i));
    }
  }
  Points points(3, static_cast<Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) points.col(static_cast<Index>(i)) = kept[i];
  return points;
}

}  // namespace gmcr::synthetic
