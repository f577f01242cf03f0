#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/features/cloud_scales.hpp"

namespace gmcr::frontend {

/// What a file of a prepared cloud says.
struct PreparedFile {
  Points points;              ///< 3 x N, metres
  double voxel_size = 0;      ///< metres
  double normal_radius = 0;   ///< voxels
  double feature_radius = 0;  ///< voxels
  Eigen::Vector3d viewpoint;  ///< metres
  std::vector<KnownSurface> surfaces;
  Index num_given = 0;  ///< points that these were made of; as many as there are for a cloud
};

/// A binary PLY, with a checksum of all that it says.
std::string write_prepared(const PreparedFile& file);

/// Whether bytes begin like such a file, of whatever version.
bool is_prepared(std::string_view bytes);

/// @throws std::invalid_argument where it is no such file, of another version, cut or changed.
PreparedFile read_prepared(std::string_view bytes);

}  // namespace gmcr::frontend
