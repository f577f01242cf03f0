#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/checks.hpp"
#include "io/text.hpp"

namespace gmcr::io {
namespace {

enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::optional<Type> type_of(std::string_view name) {
  if (name == "char" || name == "int8") return Type::Int8;
  if (name == "uchar" || name == "uint8") return Type::UInt8;
  if (name == "short" || name == "int16") return Type::Int16;
  if (name == "ushort" || name == "uint16") return Type::UInt16;
  if (name == "int" || name == "int32") return Type::Int32;
  if (name == "uint" || name == "uint32") return Type::UInt32;
  if (name == "float" || name == "float32") return Type::Float32;
  if (name == "double" || name == "float64") return Type::Float64;
  return std::nullopt;
}

std::size_t size_of(Type type) {
  switch (type) {
    case Type::Int8:
    case Type::UInt8:
      return 1;
    case Type::Int16:
    case Type::UInt16:
      return 2;
    case Type::Float64:
      return 8;
    default:
      return 4;
  }
}

struct Property {
  std::string name;
  Type type = Type::Float32;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string name;
  Index count = 0;
  std::vector<Property> properties;
};

enum class Format { Ascii, LittleEndian, BigEndian };

struct Header {
  Format format = Format::Ascii;
  std::vector<Element> elements;
  std::size_t size = 0;  // bytes before the data
};

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), reader_(bytes) {}

  Header read() {
    if (reader_.next() != "ply") fail("no PLY file: it does not start with 'ply'");
    Header header;
    bool has_format = false;
    while (const auto line = reader_.next()) {
      const auto words = split_words(*line);
      if (words.empty()) fail("blank line in the header");
      if (words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        if (!has_format) fail("no format line");
        header.size = reader_.offset();
        return header;
      }
      if (words[0] == "format") {
        header.format = format(words);
        has_format = true;
      } else if (words[0] == "element") {
        header.elements.push_back(element(words));
      } else if (words[0] == "property") {
        if (header.elements.empty()) fail("a property before the first element");
        header.elements.back().properties.push_back(property(words));
      } else {
        fail(io::quoted(words[0]) + " is no header line");
      }
    }
    throw IoError(path_, 0, "truncated header: no end_header");
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  Format format(const std::vector<std::string_view>& words) const {
    if (words.size() == 3 && words[2] == "1.0") {
      if (words[1] == "ascii") return Format::Ascii;
      if (words[1] == "binary_little_endian") return Format::LittleEndian;
      if (words[1] == "binary_big_endian") return Format::BigEndian;
    }
    fail("unknown format");
  }

  Element element(const std::vector<std::string_view>& words) const {
    const auto count = words.size() == 3 ? parse_index(words[2]) : std::nullopt;
    // 2^31 - 1 is the most that Open3D's reader counts to
    if (!count || *count < 0 || *count > std::numeric_limits<std::int32_t>::max()) {
      fail("expected 'element NAME COUNT'");
    }
    return {std::string(words[1]), *count, {}};
  }

  Property property(const std::vector<std::string_view>& words) const {
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (!is_list && words.size() != 3) fail("expected 'property TYPE NAME'");
    const auto type = type_of(words[is_list ? 3 : 1]);
    const auto count_type = is_list ? type_of(words[2]) : std::nullopt;
    if (!type || (is_list && !count_type)) fail("unknown property type");
    return {std::string(words.back()), *type, count_type};
  }

  const std::filesystem::path& path_;
  LineReader reader_;
};

/// Walks over binary values.
class BinaryCursor {
 public:
  BinaryCursor(std::string_view data, std::endian order) : data_(data), order_(order) {}

  bool skip(Type type, std::size_t count) {
    if (count > (data_.size() - offset_) / size_of(type)) return false;
    offset_ += count * size_of(type);
    return true;
  }

  std::optional<std::size_t> read_count(Type type) {
    const char* at = data_.data() + offset_;
    if (!skip(type, 1)) return std::nullopt;
    switch (type) {
      case Type::UInt8:
      case Type::Int8:
        return load<std::uint8_t>(at, order_);
      case Type::UInt16:
      case Type::Int16:
        return load<std::uint16_t>(at, order_);
      default:
        return load<std::uint32_t>(at, order_);
    }
  }

 private:
  std::string_view data_;
  std::endian order_;
  std::size_t offset_ = 0;
};

/// Walks over the words of a text; stops at the first that is no number.
class TextCursor {
 public:
  explicit TextCursor(std::string_view data) : reader_(data) {}

  bool skip(Type, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!next()) return false;
    }
    return true;
  }

  std::optional<std::size_t> read_count(Type) {
    const auto value = next();
    if (!value || *value < 0 || *value > 1e9) return std::nullopt;
    return static_cast<std::size_t>(*value);
  }

  std::size_t line() const { return reader_.line(); }

 private:
  std::optional<double> next() {
    while (word_ == words_.size()) {
      const auto line = reader_.next();
      if (!line) return std::nullopt;
      words_ = split_words(*line);
      word_ = 0;
    }
    return parse_double(words_[word_++]);
  }

  LineReader reader_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

/// Index of the first row of the element that is not complete, or nullopt.
template <typename Cursor>
std::optional<Index> find_incomplete_row(const Element& element, Cursor& cursor) {
  for (Index row = 0; row < element.count; ++row) {
    for (const Property& property : element.properties) {
      std::size_t count = 1;
      if (property.count_type) {
        const auto length = cursor.read_count(*property.count_type);
        if (!length) return row;
        count = *length;
      }
      if (!cursor.skip(property.type, count)) return row;
    }
  }
  return std::nullopt;
}

std::string incomplete(const Element& element, Index row) {
  return "truncated or malformed: element '" + element.name + "' has " + std::to_string(row) +
         " of " + std::to_string(element.count) + " rows";
}

Index vertex_count(const std::filesystem::path& path, const Header& header) {
  for (const Element& element : header.elements) {
    if (element.name != "vertex") continue;
    int found = 0;
    for (const Property& property : element.properties) {
      const bool is_coordinate =
          property.name == "x" || property.name == "y" || property.name == "z";
      if (is_coordinate && !property.count_type) ++found;
    }
    if (found != 3) throw IoError(path, 0, "the vertices lack x, y or z");
    return element.count;
  }
  throw IoError(path, 0, "no element 'vertex'");
}

}  // namespace

Index check_ply(const std::filesystem::path& path, std::string_view bytes) {
  const Header header = HeaderReader(path, bytes).read();
  const Index num_vertices = vertex_count(path, header);
  for (const Element& element : header.elements) {
    if (element.properties.empty() && element.count > 0) {
      throw IoError(path, 0, "element '" + element.name + "' has no properties");
    }
  }
  const std::string_view data = bytes.substr(header.size);
  if (header.format == Format::Ascii) {
    TextCursor cursor(data);
    const std::size_t header_lines = static_cast<std::size_t>(
        std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(header.size), '\n'));
    for (const Element& element : header.elements) {
      if (const auto row = find_incomplete_row(element, cursor)) {
        throw IoError(path, header_lines + cursor.line(), incomplete(element, *row));
      }
    }
    return num_vertices;
  }
  BinaryCursor cursor(
      data, header.format == Format::LittleEndian ? std::endian::little : std::endian::big);
  for (const Element& element : header.elements) {
    if (const auto row = find_incomplete_row(element, cursor)) {
      throw IoError(path, 0, incomplete(element, *row));
    }
  }
  return num_vertices;
}

}  // namespace gmcr::io
