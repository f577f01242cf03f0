#pragma once

#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/clouds/records.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {

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

}  // namespace gmcr::io
