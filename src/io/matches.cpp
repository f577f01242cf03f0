#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/file.hpp"
#include "io/npy.hpp"
#include "io/table.hpp"
#include "io/text.hpp"

namespace gmcr {
namespace {

constexpr std::string_view kKnownExtensions = ".csv, .npy";
constexpr Index kNumColumns = 6;
constexpr Index kNumColumnsWithBound = 7;
constexpr std::string_view kWrittenHeader = "ax,ay,az,bx,by,bz";
constexpr std::string_view kWrittenBoundName = ",noise_bound";

const std::array<std::vector<std::string>, 4> kKnownNames = {{
    {"ax", "ay", "az", "bx", "by", "bz"},
    {"sx", "sy", "sz", "tx", "ty", "tz"},
    {"source_x", "source_y", "source_z", "target_x", "target_y", "target_z"},
    {"src_x", "src_y", "src_z", "dst_x", "dst_y", "dst_z"},
}};
const std::array<std::string, 3> kBoundNames = {"noise_bound", "bound", "beta"};

/// The column of the noise bounds that a header names.
std::optional<std::size_t> find_bound(const std::vector<std::string>& names) {
  for (const std::string& name : kBoundNames) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  return std::nullopt;
}

/// The columns of the end points, without names: all but the bound.
std::vector<std::size_t> columns_in_order(const io::TableShape& shape,
                                          const std::optional<std::size_t>& bound) {
  std::vector<std::size_t> columns(shape.num_columns);
  std::iota(columns.begin(), columns.end(), 0);
  if (bound) columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(*bound));
  if (columns.size() != kNumColumns) {
    throw std::invalid_argument(
        std::to_string(shape.num_columns) +
        " columns, expected 6 (ax,ay,az,bx,by,bz) or 7 (and noise_bound), or a header that names "
        "these or sx,sy,sz,tx,ty,tz");
  }
  return columns;
}

/// The columns of the end points, then that of the bound where there is one.
std::vector<std::size_t> choose_columns(const io::TableShape& shape) {
  std::optional<std::size_t> bound = find_bound(shape.names);
  if (shape.names.empty() && shape.num_columns == kNumColumnsWithBound) bound = kNumColumns;
  std::vector<std::size_t> columns;
  for (const auto& names : kKnownNames) {
    columns = io::find_columns(shape.names, names);
    if (!columns.empty()) break;
  }
  if (columns.empty()) columns = columns_in_order(shape, bound);
  if (bound) columns.push_back(*bound);
  return columns;
}

/// The rows of the file as columns, and the line of each where it has lines.
io::Table read_rows(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  if (extension != ".csv" && extension != ".npy") {
    throw IoError(path, 0, io::unknown_extension(extension, kKnownExtensions));
  }
  const std::string bytes = io::read_file(path);
  if (extension == ".csv") return io::parse_table(path, bytes, choose_columns);
  return {io::parse_npy(path, bytes, {kNumColumns, kNumColumnsWithBound}), {}};
}

bool is_bound(double value) { return value > 0 && std::isfinite(value); }

std::string shown(double value) {
  std::string text;
  io::append_number(text, value);
  return text;
}

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
  const io::Table rows = read_rows(path);
  for (Index i = 0; i < rows.values.cols(); ++i) {
    const std::string fault = fault_of(rows.values.col(i));
    if (fault.empty()) continue;
    const std::size_t line = rows.lines.empty() ? 0 : rows.lines[static_cast<std::size_t>(i)];
    throw IoError(path, line, "row " + std::to_string(i) + " (from 0): " + fault);
  }
  Matches matches{rows.values.topRows<3>(), rows.values.middleRows<3>(3), {}};
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
  rows.topRows<3>() = source;
  rows.middleRows<3>(3) = target;
  if (has_bounds) {
    rows.row(kNumColumns) = Eigen::Map<const Eigen::RowVectorXd>(noise_bounds.data(), rows.cols());
  }
  const std::string extension = io::extension_of(path);
  if (extension == ".npy") return io::write_file(path, io::format_npy(rows));
  if (extension != ".csv") {
    throw IoError(path, 0, io::unknown_extension(extension, kKnownExtensions));
  }
  std::string header(kWrittenHeader);
  if (has_bounds) header += kWrittenBoundName;
  io::write_file(path, io::format_rows(rows, ',', header + "\n"));
}

}  // namespace gmcr
