#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::bench {

/// A scan that is sought in a map.
struct MapQuery {
  std::string group;  ///< of the table
  Points scan;
  Similarity map_from_scan;
  bool is_elsewhere = false;  ///< not taken in the map at all
};

struct MapCase {
  std::string name;
  Points map;
  double voxel_size = 0;  ///< metres; 0: chosen from the map
  std::vector<MapQuery> queries;
};

struct TownSettings {
  double extent = 250;  ///< metres; streets every 80
  double drive_step = 5;
  double map_voxel = 0.1;
  std::vector<int> rings{64, 32, 16};
  int num_scans = 40;  ///< for each number of rings, and as many of another town
  std::uint64_t seed = 1;
};

/// A drive through a synthetic town, and scans of it on another day, when other cars are parked;
/// and scans of another town.
MapCase town_case(const TownSettings& settings);

/// Real scans that lie far apart in one map, and other scans of the same places, whole and cut off
/// at 30 and 20 m, in several headings.
MapCase merged_case(const std::filesystem::path& data, int num_headings, std::uint64_t seed);

}  // namespace gmcr::bench
