#pragma once

#include <filesystem>
#include <string_view>

#include "gmcr/types.hpp"

namespace gmcr::io {

// Open3D 0.16 believes the headers that it reads: it allocates what they promise, pads what is
// missing and prints to stderr. So the checks come first, and what passes them, Open3D decodes.

/// Number of vertices of a PLY file that is complete: every element of the header is there, has its
/// values, and the vertices have x, y and z.
/// @throws IoError otherwise. Cost: O(size).
Index check_ply(const std::filesystem::path& path, std::string_view bytes);

/// Points of a PCD file, 3 x N, N may be 0. Ascii and binary data are decoded here, because Open3D
/// 0.16 reads coordinates of 8 bytes as 0; binary_compressed by Open3D, which limits it to 4 bytes.
/// @throws IoError where the file is not complete or lacks x, y or z.
Points parse_pcd(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gmcr::io
