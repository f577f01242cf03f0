#include "io/tables/table_sample.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "gmcr/io.hpp"
#include "io/tables/column_names.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr std::size_t kMostHeaderLines = 50;

/// What a cell below a name may say of it.
constexpr std::array<std::string_view, 21> kUnits = {
    "-",     "m",     "mm",    "cm",      "km",      "ft",     "in",
    "deg",   "rad",   "s",     "ms",      "float",   "double", "int",
    "uint8", "int32", "int64", "float32", "float64", "string", "unitless"};

std::string_view unquoted(std::string_view cell) {
  const bool is_quoted = cell.size() >= 2 && cell.front() == cell.back() &&
                         (cell.front() == '"' || cell.front() == '\'');
  return is_quoted ? trim(cell.substr(1, cell.size() - 2)) : cell;
}

/// The parts of a line, whatever separates them.
std::vector<std::string_view> words_of_row(std::string_view line, std::string& blanked) {
  blanked = line;
  std::replace_if(
      blanked.begin(), blanked.end(),
      [](char c) { return c == ';' || c == ',' || c == '"' || c == '\''; }, ' ');
  return split_words(blanked);
}

bool has_number(std::string_view line) {
  std::string blanked;
  const auto words = words_of_row(line, blanked);
  return std::any_of(words.begin(), words.end(),
                     [](std::string_view word) { return parse_cell(word).has_value(); });
}

/// A row of cells that all say that there is no number, or that are empty.
bool is_missing_row(std::string_view line) {
  std::string blanked;
  const auto words = words_of_row(line, blanked);
  return std::all_of(words.begin(), words.end(), is_missing);
}

bool is_unit(std::string_view cell) {
  return cell.empty() || cell.starts_with('[') || cell.starts_with('(') ||
         std::find(kUnits.begin(), kUnits.end(), to_lower(cell)) != kUnits.end();
}

bool is_units_row(std::string_view line, char separator) {
  const auto cells = split_quoted(line, separator);
  return !is_missing_row(line) && std::all_of(cells.begin(), cells.end(), is_unit);
}

std::string_view without_comment_mark(std::string_view line) {
  line = trim(line);
  while (line.starts_with('#') || line.starts_with('/') || line.starts_with('%')) {
    line.remove_prefix(1);
  }
  return trim(line);
}

/// "X (m)" is x.
std::string column_name(std::string_view cell) {
  cell = without_comment_mark(cell);
  const std::size_t unit = cell.find_first_of("([");
  const bool is_index = cell.find_first_of("0123456789", unit) == unit + 1;  // XYZ[0]
  if (unit != std::string_view::npos && unit > 0 && !is_index) cell = cell.substr(0, unit);
  return to_lower(trim(cell));
}

/// Names of a header. Where blanks are between them, a unit in brackets is none, nor is a first
/// word with a colon ("columns: x y z"). An empty name behind the last column is left out.
std::vector<std::string> names_of(std::string_view header, char separator,
                                  std::size_t num_columns) {
  std::vector<std::string> names;
  for (const std::string_view cell : split_quoted(header, separator)) {
    const bool is_unit_of_name = !names.empty() && (cell.starts_with('[') || cell.starts_with('('));
    const bool is_title = names.empty() && cell.ends_with(':');
    if (separator == ' ' && (is_unit_of_name || is_title)) continue;
    names.push_back(column_name(cell));
  }
  if (!names.empty() && names.back().empty() && names.size() != num_columns) names.pop_back();
  return names;
}

/// The names as far as they are those of coordinates from the first column on, where blanks in the
/// names behind them make them too many; else none.
std::vector<std::string> leading_names(std::vector<std::string> names, std::size_t num_columns) {
  const auto other = std::find_if_not(names.begin(), names.end(), is_coordinate);
  const auto num_leading = static_cast<std::size_t>(other - names.begin());
  if (names.size() <= num_columns || num_leading >= num_columns) return {};
  names.resize(num_leading);
  names.resize(num_columns);
  return names;
}

/// What a line says of as many columns, or of any number where that is 0; nullopt: nothing.
std::optional<TableHeader> header_of(const TableLine& line, char separator,
                                     std::size_t num_columns) {
  std::optional<TableHeader> misfit;
  for (const char mark : {separator, ';', ',', ' '}) {
    auto names = names_of(line.text, mark, num_columns);
    if (!name_coordinates(names)) continue;
    const std::size_t num_names = names.size();
    const bool fits = num_columns == 0 || num_names == num_columns;
    if (!fits && mark == ' ') names = leading_names(std::move(names), num_columns);
    if (fits || (mark == ' ' && name_coordinates(names)))
      return TableHeader{std::move(names), line, num_names, true, {}};
    misfit = {{}, line, num_names, true, {}};
  }
  return misfit;
}

/// The line of words that is closest to the rows, and its cells where there are as many as columns.
TableHeader header_of_words(const std::vector<TableLine>& before, char separator,
                            std::size_t num_columns) {
  const auto line = std::find_if(before.rbegin(), before.rend(), [&](const TableLine& each) {
    return !each.is_comment && !is_missing_row(each.text) && !is_units_row(each.text, separator);
  });
  if (line == before.rend()) return {};
  for (const char mark : {separator, ';', ',', ' '}) {
    auto names = names_of(line->text, mark, num_columns);
    const std::size_t num_names = names.size();
    if (num_columns == 0 || num_names == num_columns)
      return {std::move(names), *line, num_names, false, {}};
  }
  return {{}, *line, names_of(line->text, separator, num_columns).size(), false, {}};
}

TableHeader header_among(const std::vector<TableLine>& before, char separator,
                         std::size_t num_columns) {
  TableHeader misfit;
  for (auto line = before.rbegin(); line != before.rend(); ++line) {
    auto header = header_of(*line, separator, num_columns);
    if (header && !header->names.empty()) return std::move(*header);
    if (header && misfit.line.number == 0 && !line->is_prose) misfit = std::move(*header);
  }
  return misfit.line.number > 0 ? misfit : header_of_words(before, separator, num_columns);
}

}  // namespace

TableSample sample_table(const std::filesystem::path& path, std::string_view text,
                         const TableRules& rules) {
  if (text.find('\0') != std::string_view::npos) {
    throw IoError(path, 0, "no text: it holds bytes of value 0");
  }
  TableSample sample;
  std::size_t num_words = 0;
  LineReader reader(text);
  while (const auto line = reader.next()) {
    if (sample.rows.size() == kSampledRows) break;
    if (is_content(*line)) {
      if (rules.allows_counts && lone_integer(*line)) continue;
      if (!sample.rows.empty() || has_number(*line)) {
        sample.rows.push_back({*line, reader.line()});
        continue;
      }
      sample.before.push_back({*line, reader.line()});
      if (!is_missing_row(*line) && ++num_words > kMostHeaderLines) {
        throw IoError(path, reader.line(), "no row of numbers so far");
      }
    } else if (sample.rows.empty() && !trim(*line).empty()) {
      const bool is_prose = !trim(*line).starts_with("//");
      sample.before.push_back({without_comment_mark(*line), reader.line(), true, is_prose});
    }
  }
  return sample;
}

TableHeader find_header(const std::vector<TableLine>& before, char separator,
                        std::size_t num_columns) {
  TableHeader header = header_among(before, separator, num_columns);
  for (const TableLine& line : before) {
    if (!line.is_comment && line.number > header.line.number) header.rows.push_back(line);
  }
  if (!header.rows.empty() && is_units_row(header.rows[0].text, separator)) {
    header.rows.erase(header.rows.begin());
  }
  return header;
}

std::vector<std::string_view> split_quoted(std::string_view line, char separator) {
  const bool is_blank = separator == ' ';
  if (line.find('"') == std::string_view::npos && line.find('\'') == std::string_view::npos) {
    return is_blank ? split_words(line) : split_cells(line, separator);
  }
  const auto separates = [&](char c) { return is_blank ? trim({&c, 1}).empty() : c == separator; };
  std::vector<std::string_view> cells;
  bool is_inside = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const std::string_view cell = trim(line.substr(begin, i - begin));
    if (i < line.size() && line[i] == '"' && (is_inside || cell.empty())) is_inside = !is_inside;
    if (i < line.size() && (is_inside || !separates(line[i]))) continue;
    if (!is_blank || !cell.empty()) cells.push_back(unquoted(cell));
    begin = i + 1;
  }
  return cells;
}

}  // namespace gmcr::io
