#include "io/tables/table_layout.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "gmcr/io.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr char kWhiteSpace = ' ';
constexpr std::size_t kSampledRows = 200;
constexpr std::size_t kMostHeaderLines = 50;

std::vector<std::string_view> split(std::string_view row, char separator) {
  return separator == kWhiteSpace ? split_words(row) : split_cells(row, separator);
}

bool is_number(std::string_view cell) { return parse_cell(cell).has_value(); }

/// No part of the line is a number, whatever separates its parts.
bool is_header(std::string_view line) {
  std::string blanked(line);
  std::replace_if(
      blanked.begin(), blanked.end(), [](char c) { return c == ';' || c == ','; }, ' ');
  const auto words = split_words(blanked);
  return std::none_of(words.begin(), words.end(), is_number);
}

std::string_view without_comment_mark(std::string_view line) {
  line = trim(line);
  while (line.starts_with('#') || line.starts_with('/') || line.starts_with('%')) {
    line.remove_prefix(1);
  }
  return trim(line);
}

/// "X (m)" and "\"x\"" are x.
std::string column_name(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = cell.substr(1, cell.size() - 2);
  }
  cell = without_comment_mark(cell);
  const std::size_t unit = cell.find_first_of("([");
  const bool is_index = cell.find_first_of("0123456789", unit) == unit + 1;  // XYZ[0]
  if (unit != std::string_view::npos && unit > 0 && !is_index) cell = cell.substr(0, unit);
  return to_lower(trim(cell));
}

std::vector<std::string> names_of(std::string_view header, char separator) {
  std::vector<std::string> names;
  for (const std::string_view cell : split(header, separator)) names.push_back(column_name(cell));
  if (!names.empty() && names.back().empty()) names.pop_back();
  return names;
}

struct Sample {
  std::vector<std::string_view> rows;
  std::string_view header;
  std::size_t header_line = 0;
  std::size_t num_headers = 0;
  std::string_view comment;  // the last before the first row
  std::size_t first_row = 0;
};

Sample sample_of(const std::filesystem::path& path, std::string_view text,
                 const TableRules& rules) {
  if (text.find('\0') != std::string_view::npos) {
    throw IoError(path, 0, "no text: it holds bytes of value 0");
  }
  Sample sample;
  LineReader reader(text);
  while (const auto line = reader.next()) {
    if (sample.rows.size() == kSampledRows) break;
    if (!is_content(*line)) {
      if (sample.rows.empty() && !trim(*line).empty()) sample.comment = *line;
      continue;
    }
    if (rules.allows_counts && lone_integer(*line)) continue;
    if (sample.rows.empty() && is_header(*line)) {
      if (++sample.num_headers > kMostHeaderLines) {
        throw IoError(path, reader.line(), "no row of numbers so far");
      }
      sample.header = *line;
      sample.header_line = reader.line();
      continue;
    }
    if (sample.rows.empty()) sample.first_row = reader.line();
    sample.rows.push_back(*line);
  }
  return sample;
}

bool has(const std::vector<std::string_view>& rows, char mark) {
  return std::any_of(rows.begin(), rows.end(), [mark](std::string_view row) {
    return row.find(mark) != std::string_view::npos;
  });
}

/// Whether every cell of every row is a number.
bool reads(const std::vector<std::string_view>& rows, char separator, char decimal) {
  return std::all_of(rows.begin(), rows.end(), [&](std::string_view row) {
    const auto cells = split(row, separator);
    return std::all_of(cells.begin(), cells.end(), [&](std::string_view cell) {
      return parse_cell(cell, decimal).has_value();
    });
  });
}

/// Decimal mark of cells between semicolons: a comma where one makes a number of them and no point
/// does.
char decimal_of(const std::vector<std::string_view>& rows) {
  bool has_comma = false;
  for (const std::string_view row : rows) {
    for (const std::string_view cell : split(row, ';')) {
      if (cell.find(',') == std::string_view::npos) continue;
      if (!parse_cell(cell, ',')) return '.';
      has_comma = true;
    }
  }
  return has_comma ? ',' : '.';
}

void set_separator(const std::vector<std::string_view>& rows, TableLayout& layout) {
  if (has(rows, ';')) {
    layout.separator = ';';
    layout.decimal = decimal_of(rows);
  } else if (has(rows, ',')) {
    const bool is_decimal = !reads(rows, ',', '.') && reads(rows, kWhiteSpace, ',');
    layout.separator = is_decimal ? kWhiteSpace : ',';
    layout.decimal = is_decimal ? ',' : '.';
  }
  layout.has_trailing_separator = layout.separator != kWhiteSpace &&
                                  std::all_of(rows.begin(), rows.end(), [&](std::string_view row) {
                                    return trim(row).ends_with(layout.separator);
                                  });
}

void set_names(const Sample& sample, TableLayout& layout) {
  const std::size_t num_columns = layout.shape.num_columns;
  for (const std::string_view header : {sample.header, without_comment_mark(sample.comment)}) {
    for (const char separator : {layout.separator, ';', ',', kWhiteSpace}) {
      std::vector<std::string> names = names_of(header, separator);
      if (names.size() != num_columns) continue;
      // a comment need not speak of columns
      const bool is_comment = header.data() != sample.header.data();
      if (is_comment && std::find(names.begin(), names.end(), "x") == names.end()) continue;
      layout.shape.names = std::move(names);
      return;
    }
  }
}

bool is_integer_text(std::string_view cell) { return parse_index(cell).has_value(); }

/// What the numbers of a column say; cells that say that there is none are left out.
class ColumnReader {
 public:
  void add(std::string_view cell, char decimal) {
    const auto value = parse_cell(cell, decimal);
    if (value) return add(*value, is_integer_text(cell));
    if (!is_missing(cell)) facts_ = {false, false, false, false, false};
  }

  void add(double value, bool is_integer) {
    facts_.is_integer = facts_.is_integer && is_integer;
    facts_.is_distinct =
        facts_.is_distinct && value == std::floor(value) && known_.insert(value).second;
    if (before_) {
      facts_.is_increasing = facts_.is_increasing && value > *before_;
      facts_.counts_rows = facts_.counts_rows && value == *before_ + 1;
    }
    before_ = value;
  }

  const ColumnFacts& facts() const { return facts_; }

 private:
  ColumnFacts facts_;
  std::optional<double> before_;
  std::set<double> known_;
};

void set_facts(const std::vector<std::string_view>& rows, TableLayout& layout) {
  TableShape& shape = layout.shape;
  std::vector<ColumnReader> columns(shape.num_columns);
  for (const std::string_view row : rows) {
    const auto cells = split_row(row, layout);
    if (cells.size() != shape.num_columns) break;  // an error, which names its line
    for (std::size_t j = 0; j < cells.size(); ++j) columns[j].add(cells[j], layout.decimal);
    ++shape.num_rows;
  }
  for (const ColumnReader& column : columns) shape.columns.push_back(column.facts());
}

/// "1,5,2,25,3,75" may be three numbers with decimal commas or six integers.
bool may_be_decimal_commas(const std::vector<std::string_view>& rows, const TableLayout& layout) {
  if (layout.separator != ',' || layout.shape.num_columns < 6 ||
      layout.shape.num_columns % 2 != 0 || !layout.shape.names.empty()) {
    return false;
  }
  bool has_leading_zero = false;
  for (const std::string_view row : rows) {
    const auto cells = split_row(row, layout);
    for (std::size_t j = 0; j < cells.size(); ++j) {
      if (!is_integer_text(cells[j])) return false;
      if (j % 2 == 0) continue;
      if (cells[j].find_first_not_of("0123456789") != std::string_view::npos) return false;
      has_leading_zero = has_leading_zero || (cells[j].size() > 1 && cells[j].starts_with('0'));
    }
  }
  return has_leading_zero;
}

}  // namespace

bool may_number_rows(const TableShape& shape) {
  constexpr std::size_t kFewRows = 3;
  const auto& columns = shape.columns;
  if (shape.num_columns < 4 || shape.num_rows < kFewRows) return false;
  if (columns[0].is_integer && columns[0].counts_rows) return true;
  if (!columns[0].is_integer && !columns[0].is_distinct) return false;
  return std::none_of(columns.begin() + 1, columns.begin() + 4,
                      [](const ColumnFacts& facts) { return facts.is_integer; });
}

TableShape shape_of(const Eigen::Ref<const Eigen::MatrixXd>& values) {
  TableShape shape;
  shape.num_columns = static_cast<std::size_t>(values.rows());
  shape.num_rows = std::min(kSampledRows, static_cast<std::size_t>(values.cols()));
  for (Index j = 0; j < values.rows(); ++j) {
    ColumnReader column;
    for (Index i = 0; i < static_cast<Index>(shape.num_rows); ++i) {
      column.add(values(j, i), values(j, i) == std::floor(values(j, i)));
    }
    shape.columns.push_back(column.facts());
  }
  // no one wrote them as integers, so a plane x = 0 is none of numbers
  shape.columns[0].is_integer = shape.columns[0].is_distinct;
  return shape;
}

bool is_content(std::string_view line) {
  const std::string_view content = trim(line);
  return !content.empty() && !content.starts_with('#') && !content.starts_with("//") &&
         !content.starts_with('%');
}

std::optional<Index> lone_integer(std::string_view line) {
  const auto words = split_words(line);
  const auto count = words.size() == 1 ? parse_index(words[0]) : std::nullopt;
  return count && *count >= 0 ? count : std::nullopt;
}

std::size_t num_decimals(std::string_view cell, char decimal) {
  const std::size_t mark = cell.find(decimal);
  if (mark == std::string_view::npos) return 0;
  return std::min(cell.find_first_not_of("0123456789", mark + 1), cell.size()) - mark - 1;
}

bool is_missing(std::string_view cell) {
  const std::string word = to_lower(cell);
  return word.empty() || word == "na" || word == "n/a" || word == "#n/a" || word == "null" ||
         word == "none";
}

std::vector<std::string_view> split_row(std::string_view line, const TableLayout& layout) {
  const std::size_t comment = std::min(line.find(" #"), line.find("\t#"));
  auto cells = split(line.substr(0, comment), layout.separator);
  if (layout.has_trailing_separator && !cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

TableLayout find_layout(const std::filesystem::path& path, std::string_view text,
                        const TableRules& rules) {
  const Sample sample = sample_of(path, text, rules);
  TableLayout layout;
  layout.first_line = sample.header_line > 0 ? sample.header_line : sample.first_row;
  layout.first_row = sample.first_row;
  if (sample.rows.empty()) {
    set_separator({sample.header}, layout);
    layout.shape.names = names_of(sample.header, layout.separator);
    layout.shape.num_columns = layout.shape.names.size();
    return layout;
  }
  set_separator(sample.rows, layout);
  layout.shape.num_columns = split_row(sample.rows[0], layout).size();
  set_names(sample, layout);
  set_facts(sample.rows, layout);
  if (may_be_decimal_commas(sample.rows, layout)) {
    throw IoError(path, sample.first_row,
                  io::quoted(sample.rows[0]) + " may be " +
                      std::to_string(layout.shape.num_columns) +
                      " integers or half as many numbers with decimal commas: put a line with the "
                      "names of the columns before it, or separate them by ';'");
  }
  if (layout.shape.names.empty() && sample.header_line > 0) {
    const auto names = names_of(sample.header, layout.separator);
    if (names.size() > 1 && names.size() > layout.shape.num_columns) {
      throw IoError(path, sample.first_row,
                    std::to_string(layout.shape.num_columns) + " columns where line " +
                        std::to_string(sample.header_line) + " has " +
                        std::to_string(names.size()));
    }
    layout.notes.push_back("line " + std::to_string(sample.header_line) + ", " +
                           io::quoted(sample.header) + ", does not name the columns");
  }
  if (layout.decimal == ',') layout.notes.push_back("commas are taken for decimal marks");
  return layout;
}

}  // namespace gmcr::io
