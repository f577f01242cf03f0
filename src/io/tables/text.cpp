#include "io/tables/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>

namespace gmcr::io {
namespace {

constexpr std::string_view kBlank = " \t\r\n\v\f";

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text.starts_with("\xEF\xBB\xBF")) offset_ = 3;
  const std::size_t end = text.find_first_of("\r\n");
  if (end != std::string_view::npos && !text.substr(end).starts_with("\r\n")) end_ = text[end];
}

std::optional<std::string_view> LineReader::next() {
  if (offset_ >= text_.size()) return std::nullopt;
  const std::size_t end = std::min(text_.find(end_, offset_), text_.size());
  std::string_view line = text_.substr(offset_, end - offset_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  offset_ = std::min(end + 1, text_.size());
  ++line_;
  return line;
}

std::string_view trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::vector<std::string_view> split_cells(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    cells.push_back(trim(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

std::optional<double> parse_double(std::string_view text) { return parse_number<double>(text); }

std::optional<double> parse_cell(std::string_view text, char decimal) {
  if (decimal == '.') {
    if (const auto value = parse_double(text)) return value;
  }
  const std::size_t mark = text.find('#');
  if (mark != std::string_view::npos) {  // 1.#INF, 1.#QNAN, -1.#IND00
    if (text.substr(0, mark) != "1." && text.substr(0, mark) != "-1.") return std::nullopt;
    const bool is_infinite = text.substr(mark).starts_with("#INF");
    const double size = is_infinite ? std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::quiet_NaN();
    return text.starts_with('-') ? -size : size;
  }
  std::string usual(text);
  for (char& c : usual) {
    if (decimal != '.' && c == '.') return std::nullopt;
    if (c == decimal) c = '.';
    if (c == 'D' || c == 'd') c = 'e';
  }
  return parse_double(usual);
}

std::optional<Index> parse_index(std::string_view text) { return parse_number<Index>(text); }

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  result.append(text.substr(0, kLongest));
  return result.append(text.size() > kLongest ? "...'" : "'");
}

std::optional<std::string> utf8_of_utf16(std::string_view bytes) {
  if (bytes.size() < 2) return std::nullopt;
  const bool has_mark = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  if (!has_mark && (bytes[0] == 0) == (bytes[1] == 0)) return std::nullopt;
  const bool is_big = has_mark ? bytes[0] == '\xFE' : bytes[0] == 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::string text;
  for (std::size_t i = has_mark ? 2 : 0; i + 1 < bytes.size(); i += 2) {
    const int code = is_big ? byte(i) << 8 | byte(i + 1) : byte(i + 1) << 8 | byte(i);
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      text += '?';
    }
  }
  return text;
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

}  // namespace gmcr::io
