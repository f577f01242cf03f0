#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/clouds/records.hpp"

namespace gmcr::io {

/// All fields of a PCD file: ascii, binary or binary_compressed. Floating numbers of an ascii file
/// are taken in double.
/// @throws IoError where the header is malformed or contradicts itself, the file is cut, or x, y or
///   z is missing.
Records parse_pcd(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a binary PCD file of these records.
std::string format_pcd(const Records& records);

}  // namespace gmcr::io
