#pragma once

#include <filesystem>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// Points of a PLY or PCD file that has been checked, in file order, 3 x N.
/// @throws IoError where Open3D fails or does not return `num_points`. Prints nothing.
Points read_with_open3d(const std::filesystem::path& path, Index num_points);

}  // namespace gmcr::io
