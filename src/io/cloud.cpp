#include <charconv>
#include <cstdint>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/checks.hpp"
#include "io/file.hpp"
#include "io/npy.hpp"
#include "io/open3d_cloud.hpp"
#include "io/table.hpp"
#include "io/text.hpp"

namespace gmcr {
namespace {

constexpr std::string_view kReadable = ".ply, .pcd, .xyz, .pts, .csv, .npy, .bin, .pcd.bin";
constexpr std::string_view kWritable = ".ply, .pcd, .xyz, .csv, .npy";

std::vector<std::size_t> choose_csv_columns(const io::TableShape& shape) {
  const auto columns = io::find_columns(shape.names, {"x", "y", "z"});
  if (!columns.empty()) return columns;
  if (shape.num_columns != 3) {
    throw std::invalid_argument(std::to_string(shape.num_columns) +
                                " columns, expected 3 or a header that names x, y and z");
  }
  return {0, 1, 2};
}

std::vector<std::size_t> choose_first_columns(const io::TableShape& shape) {
  if (!shape.names.empty()) throw std::invalid_argument("no row of numbers");
  if (shape.num_columns < 3) throw std::invalid_argument("fewer than 3 columns");
  return {0, 1, 2};
}

/// .pts: a line with the number of points, then their rows. Open3D would skip the rows it cannot
/// read.
Points parse_pts(const std::filesystem::path& path, std::string_view text) {
  io::LineReader reader(text);
  const auto count = io::parse_index(io::trim(reader.next().value_or("")));
  if (!count || *count < 0) throw IoError(path, 1, "expected the number of points");
  if (*count == 0) return {};
  Points points = io::parse_table(path, text, choose_first_columns, 1).values;
  if (points.cols() != *count) {
    throw IoError(
        path, 0,
        std::to_string(points.cols()) + " points, the first line says " + std::to_string(*count));
  }
  return points;
}

/// Rows of float32 whose first three are the coordinates.
Points parse_binary(const std::filesystem::path& path, std::string_view bytes, Index num_columns) {
  const auto row_bytes = static_cast<std::size_t>(num_columns) * sizeof(float);
  if (bytes.size() % row_bytes != 0) {
    throw IoError(path, 0,
                  "truncated: " + std::to_string(bytes.size()) + " bytes are no multiple of " +
                      std::to_string(row_bytes) + " (" + std::to_string(num_columns) +
                      " float32 a point)");
  }
  Points points(3, static_cast<Index>(bytes.size() / row_bytes));
  for (Index i = 0; i < points.cols(); ++i) {
    const char* row = bytes.data() + static_cast<std::size_t>(i) * row_bytes;
    for (Index j = 0; j < 3; ++j) points(j, i) = io::load<float>(row + 4 * j);
  }
  return points;
}

Points parse_cloud(const std::filesystem::path& path, const std::string& extension,
                   std::string_view bytes) {
  if (extension == ".ply") {
    const Index num_points = io::check_ply(path, bytes);
    return num_points == 0 ? Points() : io::read_with_open3d(path, num_points);
  }
  if (extension == ".pcd") return io::parse_pcd(path, bytes);
  if (extension == ".xyz") return io::parse_table(path, bytes, choose_first_columns).values;
  if (extension == ".pts") return parse_pts(path, bytes);
  if (extension == ".csv") return io::parse_table(path, bytes, choose_csv_columns).values;
  if (extension == ".npy") return io::parse_npy(path, bytes, {3});
  return parse_binary(path, bytes, extension == ".bin" ? 4 : 5);
}

bool is_readable(const std::string& extension) {
  for (const char* known : {".ply", ".pcd", ".xyz", ".pts", ".csv", ".npy", ".bin", ".pcd.bin"}) {
    if (extension == known) return true;
  }
  return false;
}

Cloud drop_non_finite(const std::filesystem::path& path, Points points) {
  if (points.cols() == 0) throw IoError(path, 0, "no points");
  Index kept = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (points.col(i).allFinite()) points.col(kept++) = points.col(i);
  }
  const Index num_dropped = points.cols() - kept;
  if (kept == 0) {
    throw IoError(path, 0, "no finite point among " + std::to_string(points.cols()));
  }
  points.conservativeResize(3, kept);
  return {std::move(points), num_dropped};
}

std::string ply_header(Index num_points) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(num_points) +
         "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
}

std::string pcd_header(Index num_points) {
  const std::string count = std::to_string(num_points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
         "TYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
}

template <typename Number>
std::string with_coordinates(std::string bytes, const PointsRef& points) {
  for (Index i = 0; i < points.cols(); ++i) {
    for (Index j = 0; j < 3; ++j) io::append_bytes(bytes, static_cast<Number>(points(j, i)));
  }
  return bytes;
}

}  // namespace

Cloud read_cloud(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  if (!is_readable(extension)) {
    throw IoError(path, 0, io::unknown_extension(extension, kReadable));
  }
  return drop_non_finite(path, parse_cloud(path, extension, io::read_file(path)));
}

void write_cloud(const std::filesystem::path& path, const PointsRef& points) {
  const std::string extension = io::extension_of(path);
  const Index count = points.cols();
  std::string bytes;
  if (extension == ".ply") {
    bytes = with_coordinates<double>(ply_header(count), points);
  } else if (extension == ".pcd") {
    bytes = with_coordinates<float>(pcd_header(count), points);
  } else if (extension == ".xyz") {
    bytes = io::format_rows(points, ' ', "");
  } else if (extension == ".csv") {
    bytes = io::format_rows(points, ',', "x,y,z\n");
  } else if (extension == ".npy") {
    bytes = io::format_npy(points);
  } else {
    throw IoError(path, 0, io::unknown_extension(extension, kWritable));
  }
  io::write_file(path, bytes);
}

}  // namespace gmcr
