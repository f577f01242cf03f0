#include "io/clouds/ply.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/clouds/ply_cursor.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

template <typename Cursor>
class DataReader {
 public:
  DataReader(const std::filesystem::path& path, const PlyHeader& header, Cursor cursor)
      : path_(path), header_(header), cursor_(std::move(cursor)) {}

  /// Rows may go on in the next line; where one ends within a line, all have to end with the text.
  PlyFile read() {
    try {
      read_elements();
    } catch (const IoError&) {
      check_lines();
      throw;
    }
    file_.bytes_left = cursor_.bytes_left();
    if (file_.bytes_left > 0) check_lines();
    return std::move(file_);
  }

 private:
  void read_elements() {
    for (const PlyElement& element : header_.elements) {
      check(element);
      for (Index row = 0; row < element.count; ++row) {
        if (element.name == "vertex") {
          read_vertex(element, row);
        } else {
          read_other(element, row);
        }
        cursor_.end_row();
      }
    }
    check_corners();
  }

  void check_lines() const {
    if (cursor_.long_line() > 0) throw IoError(path_, cursor_.long_line(), cursor_.long_reason());
  }

  /// Before anything is allocated: a header may promise what it likes.
  void check(const PlyElement& element) {
    if (element.properties.empty() && element.count > 0) {
      throw IoError(path_, 0, "element '" + element.name + "' has no properties");
    }
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      bytes += size_of(property.count_type.value_or(property.field.type));
    }
    if (!cursor_.can_hold(element.count, element.properties.size(), bytes)) {
      const std::string what = element.name == "vertex" ? "points" : "rows";
      throw IoError(path_, cursor_.line(),
                    "truncated: fewer than " + std::to_string(element.count) + " " + what +
                        " of element '" + element.name + "'");
    }
    if (element.name != "vertex") return;
    if (file_.vertices.num_rows > 0) throw IoError(path_, 0, "two elements 'vertex'");
    file_.vertices.num_rows = element.count;
    for (const PlyProperty& property : element.properties) {
      if (property.count_type) continue;
      file_.vertices.fields.push_back(property.field);
      file_.vertices.fields.back().type = Cursor::stored(property.field.type);
    }
    const auto rows = static_cast<std::size_t>(element.count);
    file_.vertices.bytes.reserve(rows * row_bytes(file_.vertices.fields));
  }

  [[noreturn]] void fail(const PlyElement& element, Index row) const {
    throw IoError(path_, cursor_.line(),
                  "truncated or malformed: element '" + element.name + "' has " +
                      std::to_string(row) + " of " + std::to_string(element.count) + " rows");
  }

  void read_vertex(const PlyElement& element, Index row) {
    for (const PlyProperty& property : element.properties) {
      if (property.count_type) {
        read_list(element, property, row);
      } else if (!cursor_.copy(property.field.type, file_.vertices.bytes)) {
        fail(element, row);
      }
    }
  }

  void read_other(const PlyElement& element, Index row) {
    for (const PlyProperty& property : element.properties) {
      if (!property.count_type) {
        if (!cursor_.next(property.field.type)) fail(element, row);
        continue;
      }
      read_list(element, property, row);
      const std::string& name = property.field.name;
      if (name != "vertex_indices" && name != "vertex_index") continue;
      if (element.name == "face") add_polygon(file_.triangles, list_);
      if (element.name == "tristrips") add_strips(file_.triangles, list_);
    }
  }

  /// Values of a list as integers; those that are none, which no corner may be, are -1.
  void read_list(const PlyElement& element, const PlyProperty& property, Index row) {
    const auto length = cursor_.next(*property.count_type);
    if (!length) fail(element, row);
    if (*length < 0 || *length != std::floor(*length)) {
      throw IoError(path_, cursor_.line(),
                    "row " + std::to_string(row) + " (from 0) of element '" + element.name +
                        "': a list of negative length");
    }
    const std::size_t size = size_of(property.field.type);
    const double most = static_cast<double>(cursor_.bytes_left() + 2);
    if (*length > most || (*length * static_cast<double>(size) > most && cursor_.line() == 0)) {
      fail(element, row);
    }
    list_.clear();
    const auto count = static_cast<Index>(*length);
    for (Index i = 0; i < count; ++i) {
      const auto value = cursor_.next(property.field.type);
      if (!value) fail(element, row);
      const bool is_index = *value >= 0 && *value < 9e15 && *value == std::floor(*value);
      list_.push_back(is_index ? static_cast<Index>(*value) : -1);
    }
  }

  void check_corners() const {
    for (const Triangle& triangle : file_.triangles) {
      for (const Index corner : triangle) {
        if (corner >= 0 && corner < file_.vertices.num_rows) continue;
        throw IoError(path_, 0,
                      "a face has a corner that is none of the " +
                          std::to_string(file_.vertices.num_rows) + " vertices");
      }
    }
  }

  const std::filesystem::path& path_;
  const PlyHeader& header_;
  Cursor cursor_;
  PlyFile file_;
  std::vector<Index> list_;
};

void check_vertices(const std::filesystem::path& path, const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") continue;
    std::vector<Field> fields;
    for (const PlyProperty& property : element.properties) {
      if (!property.count_type) fields.push_back(property.field);
    }
    try {
      find_coordinates(fields);
    } catch (const std::invalid_argument& error) {
      throw IoError(path, 0, std::string("the vertices lack x, y or z: ") + error.what());
    }
    return;
  }
  throw IoError(path, 0, "no vertices: no element 'vertex'");
}

std::string_view name_of(Scalar type) {
  switch (type) {
    case Scalar::Int8:
      return "char";
    case Scalar::UInt8:
      return "uchar";
    case Scalar::Int16:
      return "short";
    case Scalar::UInt16:
      return "ushort";
    case Scalar::Int32:
      return "int";
    case Scalar::UInt32:
      return "uint";
    case Scalar::Float32:
      return "float";
    default:
      return "double";
  }
}

bool is_wide_integer(Scalar type) { return type == Scalar::Int64 || type == Scalar::UInt64; }

}  // namespace

PlyFile parse_ply(const std::filesystem::path& path, std::string_view bytes) {
  const PlyHeader header = parse_ply_header(path, bytes);
  check_vertices(path, header);
  const std::string_view data = bytes.substr(header.size);
  if (header.format == PlyFormat::Ascii) {
    return DataReader(path, header, TextCursor(data, header.num_lines)).read();
  }
  const bool is_little = header.format == PlyFormat::LittleEndian;
  const std::endian order = is_little ? std::endian::little : std::endian::big;
  return DataReader(path, header, BinaryCursor(data, order)).read();
}

std::string format_ply(const Records& vertices, const std::vector<Triangle>& triangles) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(vertices.num_rows) + "\n";
  for (const Field& field : vertices.fields) {
    for (std::size_t i = 0; i < field.count; ++i) {
      bytes.append("property ").append(name_of(field.type)).append(" ").append(field.name);
      if (field.count > 1) bytes += "_" + std::to_string(i);
      bytes += '\n';
    }
  }
  if (!triangles.empty()) {
    bytes += "element face " + std::to_string(triangles.size()) +
             "\nproperty list uchar int vertex_indices\n";
  }
  bytes += "end_header\n";
  // PLY has no integers of 8 bytes: they go as doubles, which has the same size
  const bool is_plain =
      std::none_of(vertices.fields.begin(), vertices.fields.end(),
                   [](const Field& field) { return is_wide_integer(field.type); });
  if (is_plain) {
    bytes += vertices.bytes;
  } else {
    const char* at = vertices.bytes.data();
    for (Index row = 0; row < vertices.num_rows; ++row) {
      for (const Field& field : vertices.fields) {
        for (std::size_t i = 0; i < field.count; ++i, at += size_of(field.type)) {
          if (is_wide_integer(field.type)) {
            append_bytes(bytes, load_scalar(at, field.type));
          } else {
            bytes.append(at, size_of(field.type));
          }
        }
      }
    }
  }
  for (const Triangle& triangle : triangles) {
    bytes += '\3';
    for (const Index corner : triangle) append_bytes(bytes, static_cast<std::int32_t>(corner));
  }
  return bytes;
}

}  // namespace gmcr::io
