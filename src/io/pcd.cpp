#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/checks.hpp"
#include "io/open3d_cloud.hpp"
#include "io/text.hpp"

namespace gmcr::io {
namespace {

using Words = std::vector<std::string_view>;

// Open3D reads header lines into a buffer of 1024 bytes
constexpr std::size_t kLongestLine = 1000;

struct Header {
  std::vector<std::string> fields;
  std::vector<std::size_t> sizes;
  std::vector<char> types;
  std::vector<std::size_t> counts;
  Index num_points = -1;
  std::string data;
};

/// Where a coordinate stands.
struct Axis {
  std::size_t field = 0;
  std::size_t byte = 0;  // of a binary row
  std::size_t word = 0;  // of an ascii row
};

class PcdFile {
 public:
  PcdFile(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), bytes_(bytes), reader_(bytes) {}

  Points read() {
    read_header();
    check_header();
    if (header_.num_points == 0) return {};
    if (header_.data == "ascii") return read_ascii();
    if (header_.data == "binary") return read_binary();
    check_compressed();
    return read_with_open3d(path_, header_.num_points);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  [[noreturn]] void fail_truncated(const std::string& what) const {
    throw IoError(path_, 0,
                  "truncated: " + what + " for " + std::to_string(header_.num_points) + " points");
  }

  void read_header() {
    while (const auto line = reader_.next()) {
      const Words words = split_words(*line);
      if (words.empty() || words[0].starts_with('#')) continue;
      if (line->size() > kLongestLine) fail("a line longer than 1000 bytes");
      read_header_line(words);
      if (!header_.data.empty()) return;
    }
    throw IoError(path_, 0, "truncated header: no DATA line");
  }

  void read_header_line(const Words& words) {
    const std::string_view key = words[0];
    const Words values(words.begin() + 1, words.end());
    if (key == "FIELDS" || key == "COLUMNS") {
      header_.fields.assign(values.begin(), values.end());
      header_.counts.assign(values.size(), 1);
    } else if (key == "SIZE") {
      header_.sizes = numbers(values, 8);
    } else if (key == "TYPE") {
      for (const std::string_view value : values) header_.types.push_back(value.front());
    } else if (key == "COUNT") {
      header_.counts = numbers(values, 1000000);
    } else if (key == "POINTS") {
      header_.num_points =
          static_cast<Index>(single(numbers(values, std::numeric_limits<std::int32_t>::max())));
    } else if (key == "DATA") {
      header_.data = values.size() == 1 ? std::string(values[0]) : "";
      if (header_.data != "ascii" && header_.data != "binary" &&
          header_.data != "binary_compressed") {
        fail("unknown DATA format");
      }
    } else if (key != "VERSION" && key != "WIDTH" && key != "HEIGHT" && key != "VIEWPOINT") {
      fail("no PCD header line: it starts with " + io::quoted(key));
    }
  }

  std::vector<std::size_t> numbers(const Words& words, Index largest) const {
    std::vector<std::size_t> values;
    for (const std::string_view word : words) {
      const auto value = parse_index(word);
      if (!value || *value < 0 || *value > largest) {
        fail(io::quoted(word) + " is out of range");
      }
      values.push_back(static_cast<std::size_t>(*value));
    }
    return values;
  }

  std::size_t single(const std::vector<std::size_t>& values) const {
    if (values.size() != 1) fail("expected one number");
    return values[0];
  }

  void check_header() {
    const std::size_t num_fields = header_.fields.size();
    if (header_.num_points < 0) throw IoError(path_, 0, "the header has no POINTS line");
    if (header_.sizes.size() != num_fields || header_.types.size() != num_fields ||
        header_.counts.size() != num_fields) {
      throw IoError(path_, 0, "FIELDS, SIZE, TYPE and COUNT have different lengths");
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(1, "xyz"[axis]);
      const auto found = std::find(header_.fields.begin(), header_.fields.end(), name);
      if (found == header_.fields.end()) throw IoError(path_, 0, "no field " + io::quoted(name));
      axes_[axis].field = static_cast<std::size_t>(found - header_.fields.begin());
    }
    for (std::size_t i = 0; i < num_fields; ++i) {
      for (Axis& axis : axes_) {
        if (axis.field == i) axis = {i, row_bytes_, row_words_};
      }
      const std::size_t size = header_.sizes[i];
      const bool is_float = header_.types[i] == 'F' && (size == 4 || size == 8);
      const bool is_integer = (header_.types[i] == 'I' || header_.types[i] == 'U') &&
                              (size == 1 || size == 2 || size == 4 || size == 8);
      if ((!is_float && !is_integer) || header_.counts[i] < 1) {
        throw IoError(path_, 0,
                      "field " + io::quoted(header_.fields[i]) + " has no known SIZE, TYPE, COUNT");
      }
      row_bytes_ += size * header_.counts[i];
      row_words_ += header_.counts[i];
    }
  }

  Points read_ascii() {
    std::vector<double> coordinates;
    Index rows = 0;
    while (const auto line = reader_.next()) {
      const Words words = split_words(*line);
      if (words.empty()) continue;
      if (words.size() != row_words_) {
        fail(std::to_string(words.size()) + " values, expected " + std::to_string(row_words_));
      }
      for (const Axis& axis : axes_) {
        const auto value = parse_double(words[axis.word]);
        if (!value) fail(io::quoted(words[axis.word]) + " is no number");
        coordinates.push_back(*value);
      }
      if (++rows > header_.num_points) {
        fail("more rows than the " + std::to_string(header_.num_points) + " points of the header");
      }
    }
    if (rows < header_.num_points) fail_truncated(std::to_string(rows) + " rows");
    return Eigen::Map<const Points>(coordinates.data(), 3, rows);
  }

  std::size_t bytes_left() const { return bytes_.size() - reader_.offset(); }

  bool has_all_points(std::size_t num_bytes) const {
    // the division keeps a lying header from overflowing
    return static_cast<std::size_t>(header_.num_points) <= num_bytes / row_bytes_;
  }

  double coordinate(const char* row, const Axis& axis) const {
    const char* at = row + axis.byte;
    const std::size_t size = header_.sizes[axis.field];
    switch (header_.types[axis.field]) {
      case 'F':
        return size == 4 ? static_cast<double>(load<float>(at)) : load<double>(at);
      case 'I':
        if (size == 8) return static_cast<double>(load<std::int64_t>(at));
        if (size == 4) return load<std::int32_t>(at);
        return size == 2 ? load<std::int16_t>(at) : load<std::int8_t>(at);
      default:
        if (size == 8) return static_cast<double>(load<std::uint64_t>(at));
        if (size == 4) return load<std::uint32_t>(at);
        return size == 2 ? load<std::uint16_t>(at) : load<std::uint8_t>(at);
    }
  }

  Points read_binary() {
    if (!has_all_points(bytes_left())) fail_truncated(std::to_string(bytes_left()) + " bytes");
    Points points(3, header_.num_points);
    const char* row = bytes_.data() + reader_.offset();
    for (Index i = 0; i < points.cols(); ++i, row += row_bytes_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        points(static_cast<Index>(axis), i) = coordinate(row, axes_[axis]);
      }
    }
    return points;
  }

  void check_compressed() const {
    for (const Axis& axis : axes_) {
      if (header_.sizes[axis.field] != 4) {
        throw IoError(path_, 0, "binary_compressed coordinates need a SIZE of 4");
      }
    }
    if (bytes_left() < 8) fail_truncated(std::to_string(bytes_left()) + " bytes");
    const char* sizes = bytes_.data() + reader_.offset();
    const std::size_t packed = load<std::uint32_t>(sizes);
    const std::size_t unpacked = load<std::uint32_t>(sizes + 4);
    if (packed > bytes_left() - 8) fail_truncated(std::to_string(bytes_left()) + " bytes");
    if (!has_all_points(unpacked)) fail_truncated(std::to_string(unpacked) + " unpacked bytes");
    // LZF packs at most 264 bytes into 3: a larger size would only make Open3D allocate it
    if (unpacked / 100 > packed) throw IoError(path_, 0, "the unpacked size is not possible");
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  LineReader reader_;
  Header header_;
  std::array<Axis, 3> axes_;
  std::size_t row_bytes_ = 0;
  std::size_t row_words_ = 0;
};

}  // namespace

Points parse_pcd(const std::filesystem::path& path, std::string_view bytes) {
  return PcdFile(path, bytes).read();
}

}  // namespace gmcr::io
