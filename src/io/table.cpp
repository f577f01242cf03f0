#include "io/table.hpp"

#include <algorithm>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/text.hpp"

namespace gmcr::io {
namespace {

constexpr char kWhiteSpace = ' ';

char separator_of(std::string_view row) {
  if (row.find(';') != std::string_view::npos) return ';';
  if (row.find(',') != std::string_view::npos) return ',';
  return kWhiteSpace;
}

std::vector<std::string_view> split(std::string_view row, char separator) {
  return separator == kWhiteSpace ? split_words(row) : split_cells(row, separator);
}

bool is_header(const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(),
                      [](std::string_view cell) { return parse_double(cell).has_value(); });
}

std::string column_name(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = cell.substr(1, cell.size() - 2);
  }
  return to_lower(trim(cell));
}

TableShape shape_of(const std::vector<std::string_view>& cells) {
  TableShape shape;
  shape.num_columns = cells.size();
  if (is_header(cells)) {
    std::transform(cells.begin(), cells.end(), std::back_inserter(shape.names), column_name);
  }
  return shape;
}

bool is_data(std::string_view line) {
  const std::string_view content = trim(line);
  return !content.empty() && !content.starts_with('#') && !content.starts_with("//");
}

}  // namespace

Table parse_table(const std::filesystem::path& path, std::string_view text,
                  const ColumnChooser& choose, std::size_t lines_to_skip) {
  LineReader reader(text);
  for (std::size_t i = 0; i < lines_to_skip; ++i) reader.next();
  Table table;
  TableShape shape;
  std::vector<std::size_t> columns;
  std::vector<double> values;
  char separator = kWhiteSpace;
  std::size_t first_line = 0;
  while (const auto line = reader.next()) {
    if (!is_data(*line)) continue;
    if (first_line == 0) separator = separator_of(*line);
    const std::vector<std::string_view> cells = split(*line, separator);
    if (first_line == 0) {
      first_line = reader.line();
      shape = shape_of(cells);
      try {
        columns = choose(shape);
      } catch (const std::invalid_argument& error) {
        throw IoError(path, first_line, error.what());
      }
      if (!shape.names.empty()) continue;
    }
    if (cells.size() != shape.num_columns) {
      throw IoError(path, reader.line(),
                    std::to_string(cells.size()) + " columns where line " +
                        std::to_string(first_line) + " has " + std::to_string(shape.num_columns));
    }
    for (const std::size_t column : columns) {
      const auto value = parse_double(cells[column]);
      if (!value) {
        throw IoError(path, reader.line(),
                      "column " + std::to_string(column + 1) + ": " + io::quoted(cells[column]) +
                          " is no number");
      }
      values.push_back(*value);
    }
    table.lines.push_back(reader.line());
  }
  if (first_line == 0) throw IoError(path, 0, "no rows");
  table.values = Eigen::Map<const Eigen::MatrixXd>(
      values.data(), static_cast<Index>(columns.size()), static_cast<Index>(table.lines.size()));
  return table;
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

std::vector<std::size_t> find_columns(const std::vector<std::string>& names,
                                      const std::vector<std::string>& wanted) {
  std::vector<std::size_t> columns;
  for (const std::string& name : wanted) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
}

}  // namespace gmcr::io
