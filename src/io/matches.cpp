#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/clouds/npy.hpp"
#include "io/file.hpp"
#include "io/tables/column_names.hpp"
#include "io/tables/table.hpp"
#include "io/tables/text.hpp"

namespace gmcr {
namespace {

const std::vector<std::string> kKnownExtensions = {".csv", ".txt", ".npy"};
constexpr Index kNumColumns = 6;
constexpr Index kNumColumnsWithBound = 7;
constexpr std::string_view kWrittenHeader = "ax,ay,az,bx,by,bz";
constexpr std::string_view kWrittenBoundName = ",noise_bound";

const std::array<std::string, 3> kBoundNames = {"noise_bound", "bound", "beta"};
/// What a column beside the end points may be called that says how good a match is, in no unit.
const std::array<std::string, 8> kScoreNames = {
    "score", "scores", "weight", "weights", "confidence", "similarity", "probability", "ratio"};

/// The column of the noise bounds that a header names.
std::optional<std::size_t> find_bound(const std::vector<std::string>& names) {
  for (const std::string& name : kBoundNames) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  return std::nullopt;
}

std::string shown(double value) {
  std::string text;
  io::append_number(text, value);
  return text;
}

bool is_score(const std::string& name) {
  return std::find(kScoreNames.begin(), kScoreNames.end(), name) != kScoreNames.end();
}

/// The columns of the end points, without names that say so: all but the bound and scores.
std::vector<std::size_t> columns_in_order(const io::TableShape& shape,
                                          const std::optional<std::size_t>& bound) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < shape.num_columns; ++i) {
    const bool is_other = bound == i || (!shape.names.empty() && is_score(shape.names[i]));
    if (!is_other) columns.push_back(i);
  }
  if (columns.size() != kNumColumns) {
    throw std::invalid_argument(
        std::to_string(shape.num_columns) +
        " columns, expected 6 (ax,ay,az,bx,by,bz) or 7 (and noise_bound), or a header that names "
        "these or sx,sy,sz,tx,ty,tz");
  }
  return columns;
}

std::vector<std::size_t> joined(const io::Axes& source, const io::Axes& target) {
  std::vector<std::size_t> columns(source.begin(), source.end());
  columns.insert(columns.end(), target.begin(), target.end());
  return columns;
}

/// Source and target of a table whose names do not tell them apart: the first is the source.
io::ColumnChoice unnamed_sides(const io::TableShape& shape, const std::optional<std::size_t>& bound,
                               const std::vector<io::NamedPoint>& points) {
  const std::vector<std::size_t> columns =
      points.size() == 2 ? joined(points[0].axes, points[1].axes) : columns_in_order(shape, bound);
  if (shape.names.empty()) return {columns, {}};
  return {
      columns,
      {"columns " + io::quoted_names(shape.names, {columns.begin(), columns.begin() + 3}) +
       " are taken for the source, " +
       io::quoted_names(shape.names, {columns.begin() + 3, columns.end()}) + " for the target"}};
}

/// A sentence about columns that are not used, or none.
std::vector<std::string> ignored_columns(const io::TableShape& shape,
                                         const std::vector<std::size_t>& used) {
  std::vector<std::size_t> ignored;
  for (std::size_t i = 0; i < shape.names.size(); ++i) {
    if (std::find(used.begin(), used.end(), i) == used.end()) ignored.push_back(i);
  }
  if (ignored.empty()) return {};
  return {"not used: column " + io::quoted_names(shape.names, ignored)};
}

/// Of seven columns without names the first may be a number of the match, and the last no bound.
void refuse_index_column(const io::TableShape& shape) {
  if (shape.num_columns != kNumColumnsWithBound || !io::may_number_rows(shape)) return;
  const std::string what = shape.columns[0].counts_rows ? "counts the rows" : "may number the rows";
  throw std::invalid_argument("the first of 7 columns " + what +
                              ", so the others may be shifted: put a header before them, such as "
                              "index,ax,ay,az,bx,by,bz or ax,ay,az,bx,by,bz,noise_bound");
}

/// The columns of the end points, then that of the bound where there is one.
io::ColumnChoice match_columns(const io::TableShape& shape) {
  std::optional<std::size_t> bound = find_bound(shape.names);
  if (shape.names.empty() && shape.num_columns == kNumColumnsWithBound) {
    refuse_index_column(shape);
    bound = kNumColumns;
  }
  const auto points = io::find_points(shape.names);
  const auto match = io::find_match(points);
  io::ColumnChoice choice = match ? io::ColumnChoice{joined(match->source, match->target), {}}
                                  : unnamed_sides(shape, bound, points);
  if (bound) choice.indices.push_back(*bound);
  for (std::string& note : ignored_columns(shape, choice.indices)) {
    choice.notes.push_back(std::move(note));
  }
  return choice;
}

void check_extension(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  const auto& known = kKnownExtensions;
  if (std::find(known.begin(), known.end(), extension) != known.end()) return;
  throw IoError(path, 0, io::unknown_extension(extension, kKnownExtensions));
}

/// The rows of the file as columns, and the line of each where it has lines.
struct Rows {
  io::Table table;
  bool has_unnamed_bounds = false;
};

Rows read_rows(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  const bool is_text = extension == ".csv" || extension == ".txt";
  check_extension(path);
  const std::string bytes = io::read_file(path);
  if (!is_text) {
    Rows rows{{io::parse_npy(path, bytes, {kNumColumns, kNumColumnsWithBound}), {}, {}}, false};
    rows.has_unnamed_bounds = rows.table.values.rows() == kNumColumnsWithBound;
    try {
      refuse_index_column(io::shape_of(rows.table.values));
    } catch (const std::invalid_argument& error) {
      throw IoError(path, 0, error.what());
    }
    return rows;
  }
  bool is_unnamed = false;
  const auto choose = [&is_unnamed](const io::TableShape& shape) {
    is_unnamed = shape.names.empty() && shape.num_columns == kNumColumnsWithBound;
    return match_columns(shape);
  };
  Rows rows{io::parse_table(path, bytes, choose,
                            {.row_name = "matches", .allows_counts = true, .allows_missing = true}),
            false};
  rows.has_unnamed_bounds = is_unnamed;
  return rows;
}

double extent_of(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// A last column without a name is metres only where it cannot be a score.
/// A text may come from anywhere, so bounds that are large for the cloud are doubted there too.
void check_unnamed_bounds(const std::filesystem::path& path, io::Table& table) {
  constexpr Index kFewRows = 10;  // which tell nothing
  constexpr double kLikelyScore = 0.5;
  constexpr double kLargestShareOfExtent = 0.1;
  const auto bounds = table.values.row(kNumColumns);
  const double low = bounds.minCoeff();
  const double high = bounds.maxCoeff();
  const double extent =
      std::max(extent_of(table.values.topRows<3>()), extent_of(table.values.middleRows<3>(3)));
  const bool is_text = !table.lines.empty();
  const bool may_be_score = (low >= 0 && high <= 1 && high > kLikelyScore) ||
                            (is_text && high > kLargestShareOfExtent * extent);
  if (may_be_score && table.values.cols() >= kFewRows) {
    throw IoError(path, 0,
                  "the 7th column has no name and goes from " + shown(low) + " to " + shown(high) +
                      ": noise bounds in metres, or scores? Name it in a header, "
                      "ax,ay,az,bx,by,bz,noise_bound or ...,score");
  }
  table.notes.push_back("the 7th column, " + shown(low) + " to " + shown(high) +
                        ", is taken for noise bounds in metres");
}

bool is_bound(double value) { return value > 0 && std::isfinite(value); }

/// What is wrong with a row; empty: nothing.
std::string fault_of(const Eigen::Ref<const Eigen::VectorXd>& row) {
  if (!row.head<kNumColumns>().allFinite()) return "a value is not finite";
  if (row.size() == kNumColumns || is_bound(row[kNumColumns])) return "";
  return "noise bound " + shown(row[kNumColumns]) + " is not a positive finite number";
}

void check_sizes(const PointsRef& source, const PointsRef& target,
                 std::span<const double> noise_bounds) {
  const auto differs = [&](const char* name, auto count) {
    return std::invalid_argument(std::string(name) + ": " + std::to_string(count) +
                                 " where the source has " + std::to_string(source.cols()) +
                                 " points");
  };
  if (source.cols() != target.cols()) throw differs("target", target.cols());
  if (noise_bounds.empty()) return;
  if (noise_bounds.size() != static_cast<std::size_t>(source.cols())) {
    throw differs("noise_bounds", noise_bounds.size());
  }
  const auto bad = std::find_if_not(noise_bounds.begin(), noise_bounds.end(), is_bound);
  if (bad == noise_bounds.end()) return;
  throw std::invalid_argument("noise_bounds[" + std::to_string(bad - noise_bounds.begin()) +
                              "]: " + shown(*bad) + " is not a positive finite number");
}

}  // namespace

Matches read_matches(const std::filesystem::path& path) {
  Rows read = read_rows(path);
  io::Table& rows = read.table;
  for (Index i = 0; i < rows.values.cols(); ++i) {
    const std::string fault = fault_of(rows.values.col(i));
    if (fault.empty()) continue;
    const std::size_t line = rows.lines.empty() ? 0 : rows.lines[static_cast<std::size_t>(i)];
    throw IoError(path, line, "row " + std::to_string(i) + " (from 0): " + fault);
  }
  if (rows.values.cols() == 0) return {Points(3, 0), Points(3, 0), {}, std::move(rows.notes)};
  if (read.has_unnamed_bounds) check_unnamed_bounds(path, rows);
  Matches matches{
      rows.values.topRows<3>(), rows.values.middleRows<3>(3), {}, std::move(rows.notes)};
  if (rows.values.rows() == kNumColumnsWithBound) {
    const Eigen::VectorXd bounds = rows.values.row(kNumColumns);
    matches.noise_bounds.assign(bounds.begin(), bounds.end());
  }
  return matches;
}

void write_matches(const std::filesystem::path& path, const PointsRef& source,
                   const PointsRef& target, std::span<const double> noise_bounds) {
  check_sizes(source, target, noise_bounds);
  const bool has_bounds = !noise_bounds.empty();
  Eigen::MatrixXd rows(has_bounds ? kNumColumnsWithBound : kNumColumns, source.cols());
  if (source.cols() > 0) {  // else there is nothing to point to
    rows.topRows<3>() = source;
    rows.middleRows<3>(3) = target;
  }
  if (has_bounds) {
    rows.row(kNumColumns) = Eigen::Map<const Eigen::RowVectorXd>(noise_bounds.data(), rows.cols());
  }
  const std::string extension = io::extension_of(path);
  if (extension == ".npy") return io::write_file(path, io::format_npy(rows));
  check_extension(path);
  std::string header(kWrittenHeader);
  if (has_bounds) header += kWrittenBoundName;
  io::write_file(path, io::format_rows(rows, ',', header + "\n"));
}

void check_matches_output(const std::filesystem::path& path) {
  check_extension(path);
  check_output(path);
}

}  // namespace gmcr
