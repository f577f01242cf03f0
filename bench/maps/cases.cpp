#include "maps/cases.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "gmcr/io.hpp"
#include "synthetic/town/lidar.hpp"

namespace gmcr::bench {
namespace {

using synthetic::Random;

constexpr double kTiltDeg = 2;
constexpr double kVoxel = 0.5;         // metres
constexpr double kApart = 400;         // metres between the places of the merged map
constexpr double kFarthest = 150;      // metres: of the points that the merged map keeps
constexpr std::uint64_t kOther = 500;  // added to seeds: another town, or another day

void add_town_scans(MapCase& maps, const synthetic::TownOptions& options, bool is_elsewhere,
                    const TownSettings& settings) {
  const synthetic::Town town = synthetic::make_town(options);
  const synthetic::RayCaster caster(town);
  for (const int rings : settings.rings) {
    Random random(settings.seed + kOther);
    for (int k = 0; k < settings.num_scans; ++k) {
      MapQuery query;
      query.group = fmt::format("{} rings{}", rings, is_elsewhere ? ", another town" : "");
      query.is_elsewhere = is_elsewhere;
      query.map_from_scan = sensor_at(random_place(town, random), kTiltDeg, random);
      query.scan = scan(caster, query.map_from_scan, synthetic::lidar_of(rings),
                        settings.seed + static_cast<std::uint64_t>(k));
      maps.queries.push_back(std::move(query));
    }
  }
}

/// Columns whose points lie within a distance of the origin.
Points cut(const Points& points, double radius) {
  std::vector<Index> columns;
  for (Index i = 0; i < points.cols(); ++i) {
    if (points.col(i).norm() <= radius) columns.push_back(i);
  }
  return points(Eigen::all, columns);
}

}  // namespace

MapCase town_case(const TownSettings& settings) {
  synthetic::TownOptions options;
  options.extent = settings.extent;
  options.seed = settings.seed;
  options.cars_seed = settings.seed;
  const synthetic::Town town = synthetic::make_town(options);
  double length = 0;
  for (const auto& [from, to] : town.streets) length += (to - from).norm();
  MapCase maps{fmt::format("town, {:.0f} m of streets", length),
               map_of(town, settings.drive_step, settings.map_voxel, settings.seed),
               0,
               {}};
  options.cars_seed += kOther;
  add_town_scans(maps, options, false, settings);
  options.seed += kOther;
  add_town_scans(maps, options, true, settings);
  return maps;
}

MapCase merged_case(const std::filesystem::path& data, int num_headings, std::uint64_t seed) {
  Random random(seed);
  MapCase maps{"merged LiDAR scans", Points(3, 0), kVoxel, {}};
  std::vector<Points> parts;
  for (const char* pair :
       {"lidar/kitti00_000010_000000", "lidar/small_gicp", "lidar/argoverse2_sweeps",
        "lidar/lpm_car", "mining_lidar/mining_scan1_scan0", "mining_lidar/mining_scan7_scan6"}) {
    const std::filesystem::path folder = data / pair;
    if (!std::filesystem::exists(folder)) continue;
    synthetic::TownPlace place{{kApart * static_cast<double>(parts.size()), 0},
                               random.uniform(-std::numbers::pi, std::numbers::pi)};
    const Similarity map_from_target = sensor_at(place, 0, random);
    parts.push_back(
        map_from_target.apply(cut(read_cloud(folder / "target.ply").points, kFarthest)));
    const Points source = read_cloud(folder / "source.ply").points;
    const Similarity truth = read_transform(folder / "T_target_source.txt");
    for (const double radius : {std::numeric_limits<double>::infinity(), 30.0, 20.0}) {
      for (int k = 0; k < num_headings; ++k) {
        place.position.setZero();
        place.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
        Similarity turn = sensor_at(place, kTiltDeg, random);
        turn.translation.setZero();
        MapQuery query;
        query.group = std::isinf(radius) ? "whole" : fmt::format("within {:.0f} m", radius);
        query.group +=
            fmt::format(", {}", std::string(pair).substr(0, 5) == "lidar" ? "roads" : "mine");
        query.scan = turn.apply(cut(source, radius));
        query.map_from_scan = map_from_target * truth * turn.inverse();
        maps.queries.push_back(std::move(query));
      }
    }
  }
  Index size = 0;
  for (const Points& part : parts) size += part.cols();
  maps.map.resize(3, size);
  for (Index at = 0; const Points& part : parts) {
    maps.map.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return maps;
}

}  // namespace gmcr::bench
