#include <algorithm>
#include <stdexcept>

#include "io/clouds/cloud_file.hpp"
#include "io/tables/column_names.hpp"
#include "io/tables/table.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

ColumnChoice choose_named(const TableShape& shape) {
  if (const auto axes = find_cloud_point(shape.names)) {
    const std::vector<std::size_t> columns(axes->begin(), axes->end());
    const std::string names = quoted_names(shape.names, columns);
    if (names == "'x', 'y', 'z'") return {columns, {}};
    return {columns, {"x, y, z are the columns " + names}};
  }
  const std::string names = "columns " + quoted_names(shape.names);
  for (const std::string& name : shape.names) {
    if (name.starts_with("lat") || name.starts_with("lon")) {
      throw std::invalid_argument(names + ": degrees of latitude and longitude are no points");
    }
  }
  if (name_coordinates(shape.names) && find_points(shape.names).empty()) {
    throw std::invalid_argument(names + ": they do not name all of x, y and z");
  }
  if (shape.num_columns != 3) {
    throw std::invalid_argument(std::to_string(shape.num_columns) + " columns, " +
                                quoted_names(shape.names) +
                                ": expected 3 or a header that names x, y and z");
  }
  return {{0, 1, 2}, {names + " are taken for x, y, z"}};
}

/// Whether a first column looks like a number or a time of the point instead of its x.
bool may_be_index(const TableShape& shape) {
  constexpr std::size_t kManyRows = 20;
  const auto& columns = shape.columns;
  if (shape.num_columns < 4 || !columns[3].is_numeric) return false;
  if (may_number_rows(shape)) return true;
  const bool others_are_real =
      std::none_of(columns.begin() + 1, columns.begin() + 4,
                   [](const ColumnFacts& facts) { return facts.is_integer; });
  return columns[0].is_increasing && others_are_real && shape.num_rows >= kManyRows;
}

ColumnChoice choose_unnamed(const TableShape& shape, bool is_csv) {
  if (shape.num_columns < 3) {
    throw std::invalid_argument(std::to_string(shape.num_columns) +
                                " columns, fewer than 3 columns: a point has x, y and z");
  }
  constexpr std::size_t kFewRows = 4;
  constexpr std::size_t kManyColumns = 20;
  const bool is_numeric = std::all_of(shape.columns.begin(), shape.columns.end(),
                                      [](const ColumnFacts& facts) { return facts.is_numeric; });
  if (is_numeric && shape.num_rows <= kFewRows && shape.num_columns > kManyColumns) {
    throw std::invalid_argument(std::to_string(shape.num_rows) + " rows of " +
                                std::to_string(shape.num_columns) +
                                " columns: a row is a point, so it may have to be transposed");
  }
  if (shape.num_columns == 3) return {{0, 1, 2}, {}};
  if (may_be_index(shape)) {
    throw std::invalid_argument(
        std::to_string(shape.num_columns) +
        " columns, of which the first may be x or an index or a time of the point: expected a "
        "header that names x, y and z");
  }
  if (is_csv) {
    throw std::invalid_argument(std::to_string(shape.num_columns) +
                                " columns, expected 3 or a header that names x, y and z");
  }
  return {{0, 1, 2},
          {"x, y, z are the first 3 of " + std::to_string(shape.num_columns) + " columns"}};
}

}  // namespace

bool is_text_table(std::string_view extension) {
  for (const char* known : {".xyz", ".xyzn", ".xyzrgb", ".txt", ".asc", ".csv", ".pts"}) {
    if (extension == known) return true;
  }
  return false;
}

CloudFile parse_text_cloud(const std::filesystem::path& path, std::string_view text, bool is_csv) {
  const auto choose = [is_csv](const TableShape& shape) {
    if (shape.num_columns == 0) throw std::invalid_argument("no points");
    return shape.names.empty() ? choose_unnamed(shape, is_csv) : choose_named(shape);
  };
  Table table = parse_table(path, text, choose, {.allows_counts = true, .allows_missing = true});
  CloudFile file;
  file.points = table.values;
  file.notes = std::move(table.notes);
  return file;
}

}  // namespace gmcr::io
