#include "io/tables/table_layout.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "gmcr/io.hpp"
#include "io/tables/table_sample.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr char kWhiteSpace = ' ';

/// Of lines that are no comments.
std::vector<std::string_view> texts_of(const std::vector<TableLine>& lines) {
  std::vector<std::string_view> texts;
  for (const TableLine& line : lines) {
    if (!line.is_comment) texts.push_back(line.text);
  }
  return texts;
}

bool has(const std::vector<std::string_view>& rows, char mark) {
  return std::any_of(rows.begin(), rows.end(), [mark](std::string_view row) {
    return row.find(mark) != std::string_view::npos;
  });
}

/// Whether every cell of every row is a number.
bool reads(const std::vector<std::string_view>& rows, char separator, char decimal) {
  return std::all_of(rows.begin(), rows.end(), [&](std::string_view row) {
    const auto cells = split_quoted(row, separator);
    return std::all_of(cells.begin(), cells.end(), [&](std::string_view cell) {
      return parse_cell(cell, decimal).has_value();
    });
  });
}

/// Decimal mark of cells: a comma where one makes a number of them and no point does.
char decimal_of(const std::vector<std::string_view>& rows, char separator) {
  bool has_comma = false;
  for (const std::string_view row : rows) {
    for (const std::string_view cell : split_quoted(row, separator)) {
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
    layout.decimal = decimal_of(rows, ';');
  } else if (has(rows, ',')) {
    const bool is_decimal = !reads(rows, ',', '.') && reads(rows, kWhiteSpace, ',');
    layout.separator = is_decimal ? kWhiteSpace : ',';
    layout.decimal = is_decimal ? ',' : decimal_of(rows, ',');  // "1,5" between quotation marks
  }
  layout.has_trailing_separator = layout.separator != kWhiteSpace &&
                                  std::all_of(rows.begin(), rows.end(), [&](std::string_view row) {
                                    return trim(row).ends_with(layout.separator);
                                  });
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
  const bool is_comment =
      content.starts_with('#') || content.starts_with("//") || content.starts_with('%');
  // "#N/A" is a cell
  return !content.empty() &&
         (!is_comment || is_missing(content.substr(0, content.find_first_of(",; \t"))));
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
  return word.empty() || word == "-" || word == "na" || word == "n/a" || word == "#n/a" ||
         word == "#num!" || word == "null" || word == "none";
}

std::vector<std::string_view> split_row(std::string_view line, const TableLayout& layout) {
  const std::size_t comment = std::min(line.find(" #"), line.find("\t#"));
  auto cells = split_quoted(line.substr(0, comment), layout.separator);
  if (layout.has_trailing_separator && !cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

TableLayout find_layout(const std::filesystem::path& path, std::string_view text,
                        const TableRules& rules) {
  const TableSample sample = sample_table(path, text, rules);
  TableLayout layout;
  set_separator(texts_of(sample.rows.empty() ? sample.before : sample.rows), layout);
  std::size_t& num_columns = layout.shape.num_columns;
  if (!sample.rows.empty()) num_columns = split_row(sample.rows[0].text, layout).size();
  TableHeader header = find_header(sample.before, layout.separator, num_columns);
  std::vector<TableLine> lines = std::move(header.rows);
  lines.insert(lines.end(), sample.rows.begin(), sample.rows.end());
  const std::vector<std::string_view> rows = texts_of(lines);
  if (num_columns == 0) num_columns = header.names.size();
  if (num_columns == 0 && !rows.empty()) num_columns = split_row(rows[0], layout).size();
  if (!lines.empty()) layout.first_row = lines[0].number;
  const bool has_header = header.line.number > 0;
  layout.first_line = has_header && !header.line.is_comment ? header.line.number : layout.first_row;
  layout.shape.names = std::move(header.names);
  set_facts(rows, layout);
  if (may_be_decimal_commas(rows, layout)) {
    throw IoError(path, layout.first_row,
                  io::quoted(rows[0]) + " may be " + std::to_string(num_columns) +
                      " integers or half as many numbers with decimal commas: put a line with the "
                      "names of the columns before it, or separate them by ';'");
  }
  const std::string line = "line " + std::to_string(header.line.number);
  if (layout.shape.names.empty() && has_header) {
    if (header.names_coordinates || (header.num_names > 1 && header.num_names > num_columns)) {
      throw IoError(path, layout.first_row,
                    std::to_string(num_columns) + " columns where " + line + " has " +
                        std::to_string(header.num_names));
    }
    layout.notes.push_back(line + ", " + io::quoted(header.line.text) +
                           ", does not name the columns");
  } else if (has_header && header.num_names != num_columns) {
    layout.notes.push_back(line + " has " + std::to_string(header.num_names) + " names for " +
                           std::to_string(num_columns) +
                           " columns: only those before the first other name are taken");
  }
  if (layout.decimal == ',') layout.notes.push_back("commas are taken for decimal marks");
  return layout;
}

}  // namespace gmcr::io
