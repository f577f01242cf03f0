#include "io/clouds/pcd.hpp"

#include <lzf.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

using Words = std::vector<std::string_view>;

struct PcdHeader {
  std::vector<std::string> names;
  std::vector<Index> sizes;
  std::vector<std::string> types;
  std::optional<std::vector<Index>> counts;
  std::optional<Index> num_points, width, height;
  std::string data;
};

std::optional<Scalar> type_of(std::string_view type, Index size) {
  if (type == "F") {
    if (size == 4) return Scalar::Float32;
    if (size == 8) return Scalar::Float64;
    return std::nullopt;
  }
  if (type != "I" && type != "U") return std::nullopt;
  const bool has_sign = type == "I";
  switch (size) {
    case 1:
      return has_sign ? Scalar::Int8 : Scalar::UInt8;
    case 2:
      return has_sign ? Scalar::Int16 : Scalar::UInt16;
    case 4:
      return has_sign ? Scalar::Int32 : Scalar::UInt32;
    case 8:
      return has_sign ? Scalar::Int64 : Scalar::UInt64;
    default:
      return std::nullopt;
  }
}

char letter_of(Scalar type) {
  if (type == Scalar::Float32 || type == Scalar::Float64) return 'F';
  const bool has_sign = type == Scalar::Int8 || type == Scalar::Int16 || type == Scalar::Int32 ||
                        type == Scalar::Int64;
  return has_sign ? 'I' : 'U';
}

class PcdFile {
 public:
  PcdFile(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), bytes_(bytes), reader_(bytes) {}

  Records read() {
    read_header();
    set_fields();
    set_size();
    row_bytes_ = row_bytes(records_.fields);
    if (records_.num_rows == 0) return std::move(records_);
    if (header_.data == "ascii") {
      read_ascii();
    } else if (header_.data == "binary") {
      read_binary();
    } else {
      read_compressed();
    }
    return std::move(records_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  [[noreturn]] void fail_truncated(const std::string& what) const {
    throw IoError(path_, 0,
                  "truncated: " + what + " for " + std::to_string(records_.num_rows) + " points");
  }

  void read_header() {
    while (const auto line = reader_.next()) {
      const Words words = split_words(line->substr(0, line->find('#')));
      if (words.empty()) continue;
      read_header_line(words);
      if (!header_.data.empty()) return;
    }
    throw IoError(path_, 0, "truncated header: no DATA line");
  }

  void read_header_line(const Words& words) {
    const std::string_view key = words[0];
    const Words values(words.begin() + 1, words.end());
    if (key == "FIELDS" || key == "COLUMNS") {
      header_.names.assign(values.begin(), values.end());
    } else if (key == "SIZE") {
      header_.sizes = numbers(values, 8);
    } else if (key == "TYPE") {
      header_.types.assign(values.begin(), values.end());
    } else if (key == "COUNT") {
      header_.counts = numbers(values, 1000000);
    } else if (key == "POINTS") {
      header_.num_points = single(values);
    } else if (key == "WIDTH") {
      header_.width = single(values);
    } else if (key == "HEIGHT") {
      header_.height = single(values);
    } else if (key == "DATA") {
      header_.data = values.size() == 1 ? to_lower(values[0]) : "";
      if (header_.data != "ascii" && header_.data != "binary" &&
          header_.data != "binary_compressed") {
        fail("unknown DATA format " + io::quoted(values.empty() ? "" : values[0]));
      }
    } else if (key != "VERSION" && key != "VIEWPOINT") {
      fail("no PCD header line: it starts with " + io::quoted(key));
    }
  }

  std::vector<Index> numbers(const Words& words, Index largest) const {
    std::vector<Index> values;
    for (const std::string_view word : words) {
      const auto value = parse_index(word);
      if (!value || *value < 0 || *value > largest) fail(io::quoted(word) + " is out of range");
      values.push_back(*value);
    }
    return values;
  }

  Index single(const Words& words) const {
    if (words.size() != 1) fail("expected one number");
    return numbers(words, std::numeric_limits<std::int32_t>::max())[0];
  }

  void set_fields() {
    const std::size_t num_fields = header_.names.size();
    const auto& counts = header_.counts;
    const auto check = [&](const char* key, std::size_t size) {
      if (size == num_fields) return;
      throw IoError(path_, 0,
                    "FIELDS and " + std::string(key) + " have different lengths: " + key + " of " +
                        std::to_string(size) + " for " + std::to_string(num_fields) + " fields");
    };
    check("SIZE", header_.sizes.size());
    check("TYPE", header_.types.size());
    check("COUNT", counts ? counts->size() : num_fields);
    for (std::size_t i = 0; i < num_fields; ++i) {
      const auto type = type_of(header_.types[i], header_.sizes[i]);
      const Index count = counts ? (*counts)[i] : 1;
      if (!type || count < 1) {
        throw IoError(path_, 0,
                      "field " + io::quoted(header_.names[i]) +
                          " has no known SIZE, TYPE, COUNT: " + std::to_string(header_.sizes[i]) +
                          " " + header_.types[i] + " " + std::to_string(count));
      }
      records_.fields.push_back({header_.names[i], *type, static_cast<std::size_t>(count)});
    }
    try {
      find_coordinates(records_.fields);
    } catch (const std::invalid_argument& error) {
      throw IoError(path_, 0, error.what());
    }
  }

  void set_size() {
    const auto& [points, width, height] =
        std::tie(header_.num_points, header_.width, header_.height);
    // both are below 2^31
    const std::optional<Index> area =
        width ? std::optional<Index>(*width * height.value_or(1)) : std::nullopt;
    if (!points && !area) throw IoError(path_, 0, "the header has no POINTS line, and no WIDTH");
    if (points && area && *points != *area) {
      throw IoError(path_, 0,
                    "the header contradicts itself: POINTS " + std::to_string(*points) +
                        ", WIDTH times HEIGHT " + std::to_string(*area));
    }
    records_.num_rows = points ? *points : *area;
    if (width) records_.height = height.value_or(1);
  }

  void read_ascii() {
    std::size_t num_words = 0;
    for (Field& field : records_.fields) {
      num_words += field.count;
      // a text may have more digits than the type of its header
      if (field.type == Scalar::Float32) field.type = Scalar::Float64;
    }
    Index rows = 0;
    while (const auto line = reader_.next()) {
      const Words words = split_words(*line);
      if (words.empty()) continue;
      if (words.size() != num_words) {
        fail(std::to_string(words.size()) + " values, expected " + std::to_string(num_words));
      }
      if (++rows > records_.num_rows) {
        fail("more rows than the " + std::to_string(records_.num_rows) + " points of the header");
      }
      append_row(words);
    }
    if (rows < records_.num_rows) fail_truncated(std::to_string(rows) + " rows");
  }

  void append_row(const Words& words) {
    std::size_t word = 0;
    for (const Field& field : records_.fields) {
      for (std::size_t i = 0; i < field.count; ++i, ++word) {
        const auto value = parse_cell(words[word]);
        if (!value) fail(io::quoted(words[word]) + " is no number");
        append_scalar(records_.bytes, field.type, *value);
      }
    }
  }

  std::string_view data() const { return bytes_.substr(reader_.offset()); }

  bool has_all_points(std::size_t num_bytes) const {
    // the division keeps a lying header from overflowing
    return static_cast<std::size_t>(records_.num_rows) <= num_bytes / row_bytes_;
  }

  std::size_t num_bytes() const { return static_cast<std::size_t>(records_.num_rows) * row_bytes_; }

  void read_binary() {
    if (!has_all_points(data().size())) fail_truncated(std::to_string(data().size()) + " bytes");
    records_.bytes = data().substr(0, num_bytes());
  }

  void read_compressed() {
    constexpr std::size_t kSizes = 8;
    // LZF packs at most 264 bytes into 3: a larger size would only make us allocate it
    constexpr std::size_t kLargestRatio = 264 / 3;
    if (data().size() < kSizes) fail_truncated(std::to_string(data().size()) + " bytes");
    const std::size_t packed = load<std::uint32_t>(data().data());
    const std::size_t unpacked = load<std::uint32_t>(data().data() + 4);
    const std::string_view body = data().substr(kSizes);
    if (packed > body.size()) fail_truncated(std::to_string(data().size()) + " bytes");
    if (!has_all_points(unpacked)) fail_truncated(std::to_string(unpacked) + " unpacked bytes");
    if (unpacked > kLargestRatio * (packed + 1)) {
      throw IoError(path_, 0, "the unpacked size is not possible");
    }
    std::string columns(unpacked, '\0');
    const unsigned int size = lzf_decompress(body.data(), static_cast<unsigned int>(packed),
                                             columns.data(), static_cast<unsigned int>(unpacked));
    if (size == unpacked) return set_columns(columns);
    // data that does not shrink may be stored as it is
    if (packed == unpacked) return set_columns(body);
    throw IoError(path_, 0, "damaged: the compressed data cannot be unpacked");
  }

  /// Compressed data has a field of all points after the other.
  void set_columns(std::string_view columns) {
    records_.bytes.resize(num_bytes());
    std::size_t from = 0;
    std::size_t offset = 0;
    for (const Field& field : records_.fields) {
      const std::size_t size = size_of(field.type) * field.count;
      char* to = records_.bytes.data() + offset;
      for (Index row = 0; row < records_.num_rows; ++row, to += row_bytes_, from += size) {
        columns.copy(to, size, from);
      }
      offset += size;
    }
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  LineReader reader_;
  PcdHeader header_;
  Records records_;
  std::size_t row_bytes_ = 0;
};

}  // namespace

Records parse_pcd(const std::filesystem::path& path, std::string_view bytes) {
  return PcdFile(path, bytes).read();
}

std::string format_pcd(const Records& records) {
  std::string names, sizes, types, counts;
  for (const Field& field : records.fields) {
    names += " " + field.name;
    sizes += " " + std::to_string(size_of(field.type));
    types += std::string(" ") + letter_of(field.type);
    counts += " " + std::to_string(field.count);
  }
  const Index height = std::max<Index>(1, records.height);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" +
         sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " +
         std::to_string(records.num_rows / height) + "\nHEIGHT " + std::to_string(height) +
         "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(records.num_rows) +
         "\nDATA binary\n" + records.bytes;
}

}  // namespace gmcr::io
