#include "io/clouds/ply.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

/// Walks over the binary values of a file.
class BinaryCursor {
 public:
  BinaryCursor(std::string_view data, std::endian order) : data_(data), order_(order) {}

  std::optional<double> next(Scalar type) {
    if (bytes_left() < size_of(type)) return std::nullopt;
    const double value = load_scalar(data_.data() + offset_, type, order_);
    offset_ += size_of(type);
    return value;
  }

  /// Copies a value as it is, but for its byte order.
  bool copy(Scalar type, std::string& bytes) {
    const std::size_t size = size_of(type);
    if (bytes_left() < size) return false;
    const std::string_view value = data_.substr(offset_, size);
    if (order_ == std::endian::little) {
      bytes.append(value);
    } else {
      bytes.append(value.rbegin(), value.rend());
    }
    offset_ += size;
    return true;
  }

  /// Whether `count` rows of at least `row_size` values, `row_bytes` bytes in binary, can be left.
  bool can_hold(Index count, std::size_t, std::size_t row_bytes) const {
    return row_bytes == 0 || static_cast<std::size_t>(count) <= bytes_left() / row_bytes;
  }

  void end_row() {}
  static std::size_t long_line() { return 0; }
  static std::string long_reason() { return ""; }

  static Scalar stored(Scalar type) { return type; }
  std::size_t bytes_left() const { return data_.size() - offset_; }
  std::size_t line() const { return 0; }

 private:
  std::string_view data_;
  std::endian order_;
  std::size_t offset_ = 0;
};

/// Walks over the words of a text; stops at the first that is no number.
class TextCursor {
 public:
  TextCursor(std::string_view data, std::size_t lines_before)
      : data_(data), reader_(data), lines_before_(lines_before) {}

  std::optional<double> next(Scalar) {
    while (word_ == words_.size()) {
      const auto line = reader_.next();
      if (!line) return std::nullopt;
      words_ = split_words(*line);
      word_ = 0;
    }
    ++row_size_;
    return parse_cell(words_[word_++]);
  }

  /// Notes the first line that holds more than the row that ends in it.
  void end_row() {
    if (word_ < words_.size() && long_line_ == 0) {
      long_line_ = line();
      long_reason_ = std::to_string(words_.size()) + " values in a line, expected " +
                     std::to_string(row_size_) + " by the header";
    }
    row_size_ = 0;
  }

  std::size_t long_line() const { return long_line_; }
  const std::string& long_reason() const { return long_reason_; }

  bool copy(Scalar type, std::string& bytes) {
    const auto value = next(type);
    if (value) append_scalar(bytes, stored(type), *value);
    return value.has_value();
  }

  /// A word and the blank behind it take two bytes at least.
  bool can_hold(Index count, std::size_t row_size, std::size_t) const {
    return row_size == 0 || static_cast<std::size_t>(count) <= (data_.size() / 2 + 1) / row_size;
  }

  /// A text may have more digits than the type of its header.
  static Scalar stored(Scalar type) { return is_float(type) ? Scalar::Float64 : type; }

  std::size_t bytes_left() const {
    const std::string_view rest = trim(data_.substr(reader_.offset()));
    return rest.size() + (words_.size() - word_);
  }
  std::size_t line() const { return lines_before_ + reader_.line(); }

 private:
  std::string_view data_;
  LineReader reader_;
  std::size_t lines_before_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
  std::size_t row_size_ = 0;  // values of the row so far
  std::size_t long_line_ = 0;
  std::string long_reason_;
};

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
