#include <algorithm>
#include <stdexcept>

#include "io/clouds/cloud_file.hpp"
#include "io/tables/table.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

const std::vector<std::vector<std::string>> kKnownNames = {
    {"x", "y", "z"},
    {"points:0", "points:1", "points:2"},
    {"points_0", "points_1", "points_2"},
    {"px", "py", "pz"},
    {"pos_x", "pos_y", "pos_z"},
    {"position_x", "position_y", "position_z"},
    {"point_x", "point_y", "point_z"},
    {"x_coordinate", "y_coordinate", "z_coordinate"},
    {"east", "north", "elevation"},
    {"east", "north", "height"},
    {"east", "north", "up"},
    {"easting", "northing", "elevation"},
    {"easting", "northing", "height"},
    {"easting", "northing", "altitude"},
    {"e", "n", "h"},
};

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

ColumnChoice choose_named(const TableShape& shape) {
  for (const auto& names : kKnownNames) {
    const auto columns = find_columns(shape.names, names);
    if (columns.empty()) continue;
    const bool is_plain = names == kKnownNames.front();
    return {columns, is_plain ? "" : "x, y, z are the columns " + listed(names)};
  }
  for (const std::string& name : shape.names) {
    if (name.starts_with("lat") || name.starts_with("lon")) {
      throw std::invalid_argument("columns " + listed(shape.names) +
                                  ": degrees of latitude and longitude are no points");
    }
  }
  if (shape.num_columns != 3) {
    throw std::invalid_argument(std::to_string(shape.num_columns) + " columns, " +
                                listed(shape.names) +
                                ": expected 3 or a header that names x, y and z");
  }
  return {{0, 1, 2}, "columns " + listed(shape.names) + " are taken for x, y, z"};
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
  if (shape.num_columns == 3) return {{0, 1, 2}, ""};
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
          "x, y, z are the first 3 of " + std::to_string(shape.num_columns) + " columns"};
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
