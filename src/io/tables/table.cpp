#include "io/tables/table.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

/// The lines that say how many rows follow them.
class Counts {
 public:
  void add(Index count, std::size_t line) {
    if (first_line_ == 0) first_line_ = line;
    total_ += std::min(count, std::numeric_limits<Index>::max() - total_);
  }

  void check(const std::filesystem::path& path, std::size_t num_rows, const char* name) const {
    if (first_line_ == 0 || static_cast<std::size_t>(total_) == num_rows) return;
    throw IoError(
        path, 0,
        std::to_string(num_rows) + " " + name + ", " +
            (first_line_ == 1 ? "the first line" : "line " + std::to_string(first_line_)) +
            " says " + std::to_string(total_));
  }

 private:
  std::size_t first_line_ = 0;
  Index total_ = 0;
};

bool has_short_exponent(std::string_view cell) {
  const std::size_t mark = cell.find_first_of("eE");
  return mark != std::string_view::npos &&
         cell.size() - std::min(cell.find_first_of("0123456789", mark), cell.size()) < 2;
}

class TableReader {
 public:
  TableReader(const std::filesystem::path& path, std::string_view text, const TableRules& rules)
      : path_(path), text_(text), rules_(rules), layout_(find_layout(path, text, rules)) {}

  Table read(const ColumnChooser& choose) {
    if (layout_.first_line == 0) throw IoError(path_, 0, "no rows");
    set_columns(choose);
    LineReader reader(text_);
    while (const auto line = reader.next()) read_line(*line, reader.line());
    counts_.check(path_, table_.lines.size(), rules_.row_name);
    if (rules_.checks_end && !text_.ends_with('\n') && !text_.ends_with('\r')) check_end();
    table_.values =
        Eigen::Map<const Eigen::MatrixXd>(values_.data(), static_cast<Index>(columns_.size()),
                                          static_cast<Index>(table_.lines.size()));
    return std::move(table_);
  }

 private:
  void set_columns(const ColumnChooser& choose) {
    try {
      ColumnChoice choice = choose(layout_.shape);
      columns_ = std::move(choice.indices);
      table_.notes = layout_.notes;
      std::move(choice.notes.begin(), choice.notes.end(), std::back_inserter(table_.notes));
    } catch (const std::invalid_argument& error) {
      throw IoError(path_, layout_.first_line, error.what());
    }
  }

  void read_line(std::string_view text, std::size_t line) {
    if (!is_content(text)) return;
    if (rules_.allows_counts) {
      if (const auto count = lone_integer(text)) return counts_.add(*count, line);
    }
    if (layout_.first_row == 0 || line < layout_.first_row) return;
    last_row_ = split_row(text, layout_);
    if (last_row_.size() != layout_.shape.num_columns) {
      throw IoError(path_, line,
                    std::to_string(last_row_.size()) + " columns where line " +
                        std::to_string(layout_.first_line) + " has " +
                        std::to_string(layout_.shape.num_columns));
    }
    for (const std::size_t column : columns_) values_.push_back(number(column, line));
    table_.lines.push_back(line);
  }

  double number(std::size_t column, std::size_t line) const {
    const std::string_view cell = last_row_[column];
    if (const auto value = parse_cell(cell, layout_.decimal)) return *value;
    if (rules_.allows_missing && is_missing(cell)) return std::numeric_limits<double>::quiet_NaN();
    throw IoError(
        path_, line,
        "column " + std::to_string(column + 1) + ": " + io::quoted(cell) + " is no number");
  }

  /// A last line without an end may be cut inside its last number.
  void check_end() {
    constexpr std::size_t kFewRows = 5;  // which may be written by hand
    if (last_row_.empty()) return;
    const std::string_view cell = last_row_.back();
    const ColumnFacts& facts = layout_.shape.columns.back();
    const bool has_others = table_.lines.size() > kFewRows && facts.is_numeric;
    if (cell.empty() || has_short_exponent(cell) ||
        (has_others && cell.find('e') == std::string_view::npos &&
         num_decimals(cell, layout_.decimal) < fewest_decimals_before_last())) {
      throw IoError(path_, table_.lines.back(),
                    "truncated: the file ends inside a line, with " + io::quoted(cell) +
                        "; if it is whole, end the line");
    }
    if (has_others) table_.notes.push_back("the last line has no end: the file may be cut there");
  }

  /// Of the last column in the first rows, the last one of the file left out.
  std::size_t fewest_decimals_before_last() const {
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    LineReader reader(text_);
    while (const auto line = reader.next()) {
      if (reader.line() < layout_.first_row || !is_content(*line)) continue;
      if (reader.line() >= table_.lines.back()) break;
      const auto cells = split_row(*line, layout_);
      if (cells.size() != layout_.shape.num_columns) continue;
      fewest = std::min(fewest, num_decimals(cells.back(), layout_.decimal));
    }
    return fewest == std::numeric_limits<std::size_t>::max() ? 0 : fewest;
  }

  const std::filesystem::path& path_;
  std::string_view text_;
  const TableRules& rules_;
  TableLayout layout_;
  Counts counts_;
  std::vector<std::size_t> columns_;
  std::vector<double> values_;
  std::vector<std::string_view> last_row_;
  Table table_;
};

}  // namespace

Table parse_table(const std::filesystem::path& path, std::string_view text,
                  const ColumnChooser& choose, const TableRules& rules) {
  const auto utf8 = utf8_of_utf16(text);
  return TableReader(path, utf8 ? *utf8 : text, rules).read(choose);
}

std::string format_rows(const Eigen::Ref<const Eigen::MatrixXd>& values, char separator,
                        std::string_view header) {
  std::string text(header);
  for (Index i = 0; i < values.cols(); ++i) {
    for (Index j = 0; j < values.rows(); ++j) {
      if (j > 0) text += separator;
      append_number(text, values(j, i));
    }
    text += '\n';
  }
  return text;
}

std::string quoted_names(const std::vector<std::string>& names,
                         const std::vector<std::size_t>& indices) {
  std::string text;
  const auto add = [&](const std::string& name) {
    text += (text.empty() ? "'" : ", '") + name + "'";
  };
  for (const std::size_t i : indices) add(names[i]);
  if (indices.empty()) std::for_each(names.begin(), names.end(), add);
  return text;
}

}  // namespace gmcr::io
