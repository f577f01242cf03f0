#include <array>
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
constexpr std::string_view kWrittenHeader = "ax,ay,az,bx,by,bz\n";

const std::array<std::vector<std::string>, 4> kKnownNames = {{
    {"ax", "ay", "az", "bx", "by", "bz"},
    {"sx", "sy", "sz", "tx", "ty", "tz"},
    {"source_x", "source_y", "source_z", "target_x", "target_y", "target_z"},
    {"src_x", "src_y", "src_z", "dst_x", "dst_y", "dst_z"},
}};

std::vector<std::size_t> choose_columns(const io::TableShape& shape) {
  for (const auto& names : kKnownNames) {
    const auto columns = io::find_columns(shape.names, names);
    if (!columns.empty()) return columns;
  }
  if (shape.num_columns != kNumColumns) {
    throw std::invalid_argument(
        std::to_string(shape.num_columns) +
        " columns, expected 6 (ax,ay,az,bx,by,bz), or a header that names these or "
        "sx,sy,sz,tx,ty,tz");
  }
  return {0, 1, 2, 3, 4, 5};
}

/// The rows of the file as columns, and the line of each where it has lines.
io::Table read_rows(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  if (extension != ".csv" && extension != ".npy") {
    throw IoError(path, 0, io::unknown_extension(extension, kKnownExtensions));
  }
  const std::string bytes = io::read_file(path);
  if (extension == ".csv") return io::parse_table(path, bytes, choose_columns);
  return {io::parse_npy(path, bytes, kNumColumns), {}};
}

}  // namespace

Matches read_matches(const std::filesystem::path& path) {
  const io::Table rows = read_rows(path);
  for (Index i = 0; i < rows.values.cols(); ++i) {
    if (rows.values.col(i).allFinite()) continue;
    const std::size_t line = rows.lines.empty() ? 0 : rows.lines[static_cast<std::size_t>(i)];
    throw IoError(path, line, "row " + std::to_string(i) + " (from 0): a value is not finite");
  }
  return {rows.values.topRows<3>(), rows.values.bottomRows<3>(), {}};
}

void write_matches(const std::filesystem::path& path, const PointsRef& source,
                   const PointsRef& target) {
  if (source.cols() != target.cols()) {
    throw std::invalid_argument("target: " + std::to_string(target.cols()) +
                                " points where the source has " + std::to_string(source.cols()));
  }
  Eigen::MatrixXd rows(kNumColumns, source.cols());
  rows << source, target;
  const std::string extension = io::extension_of(path);
  if (extension == ".npy") return io::write_file(path, io::format_npy(rows));
  if (extension == ".csv") return io::write_file(path, io::format_rows(rows, ',', kWrittenHeader));
  throw IoError(path, 0, io::unknown_extension(extension, kKnownExtensions));
}

}  // namespace gmcr
