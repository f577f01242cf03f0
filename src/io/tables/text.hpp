#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// The lines of a text, without their ends (\n or \r\n, or \r where the first line ends so),
/// counted from 1.
class LineReader {
 public:
  /// Skips a UTF-8 byte order mark.
  explicit LineReader(std::string_view text);

  /// Next line, or nullopt at the end of the text.
  std::optional<std::string_view> next();

  /// Number of the line that `next` returned last.
  std::size_t line() const { return line_; }

  /// Bytes from the start of the text to the line after the last one returned.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t line_ = 0;
  char end_ = '\n';
};

std::string_view trim(std::string_view text);

/// Parts between runs of white space.
std::vector<std::string_view> split_words(std::string_view line);

/// Trimmed parts between single separators; "a," has two.
std::vector<std::string_view> split_cells(std::string_view line, char separator);

/// The whole of `text` as a number, whatever the locale; "nan" and "inf" are numbers, a leading '+'
/// is allowed. A number that a double cannot hold is none.
std::optional<double> parse_double(std::string_view text);

/// As `parse_double`, and as other tools write numbers: Fortran's exponents (1.5D+00), the
/// infinities and NaN of old C libraries (1.#INF, -1.#IND), and, with `decimal` ',', 1,5.
std::optional<double> parse_cell(std::string_view text, char decimal = '.');

/// The whole of `text` as a decimal integer.
std::optional<Index> parse_index(std::string_view text);

/// Appends the shortest text that reads back as the same bits.
void append_number(std::string& text, double value);

/// The text between quotation marks, cut where it is long: for messages.
std::string quoted(std::string_view text);

/// A text of UTF-16, which a byte order mark or a zero in one of the first two bytes tells, as
/// UTF-8; what three bytes of UTF-8 would take is '?'.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

std::string to_lower(std::string_view text);

}  // namespace gmcr::io
