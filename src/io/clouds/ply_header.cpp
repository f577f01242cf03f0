#include "gmcr/io.hpp"
#include "io/clouds/ply.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

using Words = std::vector<std::string_view>;

std::optional<Scalar> type_of(std::string_view name) {
  if (name == "char" || name == "int8") return Scalar::Int8;
  if (name == "uchar" || name == "uint8") return Scalar::UInt8;
  if (name == "short" || name == "int16") return Scalar::Int16;
  if (name == "ushort" || name == "uint16") return Scalar::UInt16;
  if (name == "int" || name == "int32") return Scalar::Int32;
  if (name == "uint" || name == "uint32") return Scalar::UInt32;
  if (name == "int64" || name == "long") return Scalar::Int64;
  if (name == "uint64" || name == "ulong") return Scalar::UInt64;
  if (name == "float" || name == "float32") return Scalar::Float32;
  if (name == "double" || name == "float64") return Scalar::Float64;
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), reader_(bytes) {}

  PlyHeader read() {
    if (trim(reader_.next().value_or("")) != "ply") {
      fail("not a PLY file: it does not start with 'ply'");
    }
    PlyHeader header;
    bool has_format = false;
    while (const auto line = reader_.next()) {
      const Words words = split_words(*line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        if (!has_format) fail("no format line");
        header.size = reader_.offset();
        header.num_lines = reader_.line();
        return header;
      }
      if (words[0] == "format") {
        header.format = format(*line, words);
        has_format = true;
      } else if (words[0] == "element") {
        header.elements.push_back(element(*line, words));
      } else if (words[0] == "property") {
        if (header.elements.empty())
          fail("a property before the first element: " + io::quoted(*line));
        header.elements.back().properties.push_back(property(*line, words));
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

  PlyFormat format(std::string_view line, const Words& words) const {
    if (words.size() == 3 && words[2] == "1.0") {
      if (words[1] == "ascii") return PlyFormat::Ascii;
      if (words[1] == "binary_little_endian") return PlyFormat::LittleEndian;
      if (words[1] == "binary_big_endian") return PlyFormat::BigEndian;
    }
    fail("unknown format: " + io::quoted(line));
  }

  PlyElement element(std::string_view line, const Words& words) const {
    const auto count = words.size() == 3 ? parse_index(words[2]) : std::nullopt;
    if (!count || *count < 0) fail("expected 'element NAME COUNT', not " + io::quoted(line));
    return {std::string(words[1]), *count, {}};
  }

  PlyProperty property(std::string_view line, const Words& words) const {
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (!is_list && words.size() != 3) {
      fail("expected 'property TYPE NAME', not " + io::quoted(line));
    }
    const auto type = type_of(words[is_list ? 3 : 1]);
    const auto count_type = is_list ? type_of(words[2]) : std::nullopt;
    if (!type || (is_list && !count_type)) fail("unknown property type: " + io::quoted(line));
    if (count_type == Scalar::Float32 || count_type == Scalar::Float64) {
      fail("the length of a list has to be an integer: " + io::quoted(line));
    }
    return {{std::string(words.back()), *type, 1}, count_type};
  }

  const std::filesystem::path& path_;
  LineReader reader_;
};

}  // namespace

PlyHeader parse_ply_header(const std::filesystem::path& path, std::string_view bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace gmcr::io
