#pragma once

#include <bit>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/clouds/records.hpp"
#include "io/meshes/mesh.hpp"

namespace gmcr::io {

struct PlyProperty {
  Field field;
  std::optional<Scalar> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  Index count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;       ///< bytes before the data
  std::size_t num_lines = 0;  ///< lines before the data
};

/// @throws IoError with the line.
PlyHeader parse_ply_header(const std::filesystem::path& path, std::string_view bytes);

/// What a PLY file says of its vertices, without their lists, and its faces.
struct PlyFile {
  Records vertices;
  std::vector<Triangle> triangles;
  std::size_t bytes_left = 0;  ///< behind the last element
};

/// Any scalar type, byte order, lists, further elements and order of properties. Floating numbers
/// of an ascii file are taken in double, whatever the header says of them.
/// @throws IoError where the file is no PLY, cut, or lacks single x, y or z.
PlyFile parse_ply(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a binary little-endian PLY file of these vertices and faces.
std::string format_ply(const Records& vertices, const std::vector<Triangle>& triangles);

}  // namespace gmcr::io
