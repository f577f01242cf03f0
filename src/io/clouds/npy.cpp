#include "io/clouds/npy.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/clouds/records.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

struct NpyHeader {
  std::string descr;
  bool fortran_order = false;
  std::vector<Index> shape;
};

/// Parser of the Python dictionary literal that a header is.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : text_(text) {}

  /// Nullopt where the text is anything else than the three fields of the format.
  std::optional<NpyHeader> parse() {
    NpyHeader header;
    bool has_descr = false, has_order = false, has_shape = false;
    if (!take('{')) return std::nullopt;
    while (!take('}')) {
      const auto key = string();
      if (!key || !take(':')) return std::nullopt;
      if (*key == "descr" && !has_descr) {
        const auto value = string();
        if (!value) return std::nullopt;
        header.descr = *value;
        has_descr = true;
      } else if (*key == "fortran_order" && !has_order) {
        if (!boolean(header.fortran_order)) return std::nullopt;
        has_order = true;
      } else if (*key == "shape" && !has_shape) {
        if (!tuple(header.shape)) return std::nullopt;
        has_shape = true;
      } else {
        return std::nullopt;
      }
      if (!take(',') && !peek('}')) return std::nullopt;
    }
    if (!trim(text_).empty() || !has_descr || !has_order || !has_shape) return std::nullopt;
    return header;
  }

 private:
  bool peek(char c) {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \t\n"), text_.size()));
    return text_.starts_with(c);
  }

  bool take(char c) {
    if (!peek(c)) return false;
    text_.remove_prefix(1);
    return true;
  }

  bool take_word(std::string_view word) {
    peek(' ');
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }

  std::optional<std::string> string() {
    const char quote = peek('"') ? '"' : '\'';
    if (!take(quote)) return std::nullopt;
    const std::size_t end = text_.find(quote);
    if (end == std::string_view::npos) return std::nullopt;
    std::string value(text_.substr(0, end));
    text_.remove_prefix(end + 1);
    return value;
  }

  bool boolean(bool& value) {
    value = take_word("True");
    return value || take_word("False");
  }

  bool tuple(std::vector<Index>& values) {
    if (!take('(')) return false;
    while (!take(')')) {
      peek(' ');
      const std::size_t end = std::min(text_.find_first_not_of("0123456789"), text_.size());
      const auto value = parse_index(text_.substr(0, end));
      if (!value) return false;
      values.push_back(*value);
      text_.remove_prefix(end);
      if (!take(',') && !peek(')')) return false;
    }
    return true;
  }

  std::string_view text_;
};

std::string shown(const std::vector<Index>& shape) {
  std::string text = "(";
  for (const Index size : shape) text += std::to_string(size) + (shape.size() == 1 ? "," : ", ");
  if (shape.size() > 1) text.resize(text.size() - 2);
  return text + ")";
}

std::string shapes_of(const std::vector<Index>& num_columns) {
  std::string text;
  for (const Index count : num_columns) {
    text += (text.empty() ? "(N, " : " or (N, ") + std::to_string(count) + ")";
  }
  return text;
}

/// Splits the bytes into header text and data.
struct Parts {
  std::string_view header;
  std::string_view data;
};

Parts split(const std::filesystem::path& path, std::string_view bytes) {
  if (!kMagic.starts_with(bytes.substr(0, kMagic.size())) && !bytes.starts_with(kMagic)) {
    throw IoError(path, 0, "no .npy file: it does not start with \\x93NUMPY");
  }
  const IoError truncated(path, 0, "truncated .npy header");
  if (bytes.size() < 8) throw truncated;
  const int major = static_cast<unsigned char>(bytes[6]);
  if (major < 1 || major > 3) {
    throw IoError(path, 0, "unknown .npy version " + std::to_string(major));
  }
  const std::size_t start = major == 1 ? 10 : 12;
  if (bytes.size() < start) throw truncated;
  const std::size_t length =
      major == 1 ? load<std::uint16_t>(bytes.data() + 8) : load<std::uint32_t>(bytes.data() + 8);
  if (bytes.size() - start < length) throw truncated;
  return {bytes.substr(start, length), bytes.substr(start + length)};
}

/// Type and byte order of a 'descr'.
struct ElementType {
  Scalar type;
  std::endian order;
};

std::optional<ElementType> element_type_of(std::string_view descr) {
  constexpr std::pair<std::string_view, Scalar> kKnown[] = {
      {"f4", Scalar::Float32}, {"f8", Scalar::Float64}, {"i1", Scalar::Int8},
      {"u1", Scalar::UInt8},   {"i2", Scalar::Int16},   {"u2", Scalar::UInt16},
      {"i4", Scalar::Int32},   {"u4", Scalar::UInt32},  {"i8", Scalar::Int64},
      {"u8", Scalar::UInt64}};
  if (descr.empty()) return std::nullopt;
  const char order = descr.front();
  if (order != '<' && order != '>' && order != '|') return std::nullopt;
  for (const auto& [name, type] : kKnown) {
    if (descr.substr(1) != name) continue;
    if (order == '|' && size_of(type) != 1) return std::nullopt;
    return ElementType{type, order == '>' ? std::endian::big : std::endian::little};
  }
  return std::nullopt;
}

Eigen::MatrixXd load_matrix(std::string_view data, const NpyHeader& header,
                            const ElementType& element) {
  const Index rows = header.shape[0];
  const Index columns = header.shape[1];
  const auto size = static_cast<Index>(size_of(element.type));
  Eigen::MatrixXd values(columns, rows);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      const Index at = header.fortran_order ? j * rows + i : i * columns + j;
      values(j, i) = load_scalar(data.data() + at * size, element.type, element.order);
    }
  }
  return values;
}

}  // namespace

Eigen::MatrixXd parse_npy(const std::filesystem::path& path, std::string_view bytes,
                          const std::vector<Index>& num_columns, bool allows_more) {
  const Parts parts = split(path, bytes);
  if (parts.header.find("'descr': [") != std::string_view::npos) {
    throw IoError(path, 0,
                  "a structured dtype: expected an array " + shapes_of(num_columns) +
                      " of numbers, as numpy.lib.recfunctions.structured_to_unstructured makes");
  }
  const auto header = HeaderParser(parts.header).parse();
  if (!header) throw IoError(path, 0, "malformed .npy header");
  const auto element = element_type_of(header->descr);
  if (!element) {
    throw IoError(path, 0,
                  "dtype '" + header->descr +
                      "' is not an array of numbers: expected '<f8', "
                      "'<f4' or integers");
  }
  const auto& shape = header->shape;
  // wider than the data would overflow
  const auto is_wider = [&] {
    return shape[1] > num_columns.back() && shape[0] > shape[1] &&
           static_cast<std::uint64_t>(shape[1]) <= parts.data.size();
  };
  if (shape.size() != 2 ||
      (std::find(num_columns.begin(), num_columns.end(), shape[1]) == num_columns.end() &&
       !(allows_more && is_wider()))) {
    throw IoError(path, 0,
                  "shape " + shown(header->shape) + ", expected " + shapes_of(num_columns));
  }
  const std::size_t row_bytes = static_cast<std::size_t>(header->shape[1]) * size_of(element->type);
  const auto rows = static_cast<std::size_t>(header->shape[0]);
  // the division keeps a lying row count from overflowing
  if (rows != parts.data.size() / row_bytes || parts.data.size() % row_bytes != 0) {
    throw IoError(path, 0,
                  "shape " + shown(header->shape) + " does not fit the " +
                      std::to_string(parts.data.size()) + " bytes of data");
  }
  return load_matrix(parts.data, *header, *element);
}

std::string format_npy(const Eigen::Ref<const Eigen::MatrixXd>& values) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                       std::to_string(values.cols()) + ", " + std::to_string(values.rows()) +
                       "), }";
  // the format wants the data to start at a multiple of 64 bytes
  constexpr std::size_t kAlignment = 64;
  const std::size_t used = kMagic.size() + 4 + header.size() + 1;
  header.append((kAlignment - used % kAlignment) % kAlignment, ' ').push_back('\n');
  std::string bytes(kMagic);
  bytes += {'\x01', '\x00'};
  append_bytes(bytes, static_cast<std::uint16_t>(header.size()));
  bytes += header;
  for (Index i = 0; i < values.cols(); ++i) {
    for (Index j = 0; j < values.rows(); ++j) append_bytes(bytes, values(j, i));
  }
  return bytes;
}

}  // namespace gmcr::io
