#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "io/clouds/cloud_file.hpp"
#include "io/clouds/npy.hpp"
#include "io/clouds/pcd.hpp"
#include "io/clouds/ply.hpp"
#include "io/file.hpp"
#include "io/tables/text.hpp"

namespace gmcr {
namespace io {
namespace {

/// Faces that use fewer of the vertices leave a cloud a cloud.
constexpr double kLeastShareOfCorners = 0.5;

CloudFile file_of(PlyFile&& ply) {
  CloudFile file;
  file.points = columns_of(ply.vertices, find_coordinates(ply.vertices.fields));
  file.records = std::move(ply.vertices);
  file.triangles = std::move(ply.triangles);
  if (ply.bytes_left > 0) {
    file.notes.push_back(std::to_string(ply.bytes_left) +
                         " bytes behind the last element of the header are left out");
  }
  return file;
}

CloudFile file_of(Records&& records) {
  CloudFile file;
  file.points = columns_of(records, find_coordinates(records.fields));
  file.records = std::move(records);
  return file;
}

CloudFile file_of(Mesh&& mesh) {
  CloudFile file;
  file.points = std::move(mesh.vertices);
  file.triangles = std::move(mesh.triangles);
  return file;
}

/// As Python takes arrays: the first three columns.
CloudFile file_of_array(const Eigen::MatrixXd& values) {
  CloudFile file;
  file.points = values.topRows<3>();
  if (values.rows() > 3) {
    file.notes.push_back("x, y, z are the first 3 of " + std::to_string(values.rows()) +
                         " columns");
  }
  return file;
}

CloudFile parse(const std::filesystem::path& path, const std::string& extension,
                std::string_view bytes, const CloudOptions& options) {
  if (extension == ".ply") return file_of(parse_ply(path, bytes));
  if (extension == ".pcd") return file_of(parse_pcd(path, bytes));
  if (is_text_table(extension)) return parse_text_cloud(path, bytes, extension == ".csv");
  if (extension == ".npy") return file_of_array(parse_npy(path, bytes, {3}, true));
  if (extension == ".obj") return file_of(parse_obj(path, bytes));
  if (extension == ".off") return file_of(parse_off(path, bytes));
  if (extension == ".stl") return file_of(parse_stl(path, bytes));
  if (extension == ".pcd.bin") return parse_binary_scan(path, bytes, 5);
  if (options.bin_columns > 0) return parse_binary_scan(path, bytes, options.bin_columns);
  return parse_unknown_scan(path, bytes);
}

void check(const CloudOptions& options) {
  const auto refuse = [](const char* name, Index value, const char* rule) {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(value) + " is not " +
                                rule);
  };
  if (options.mesh_points < 0) refuse("mesh_points", options.mesh_points, "at least 0");
  if (options.bin_columns != 0 && options.bin_columns < 3) {
    refuse("bin_columns", options.bin_columns, "0 or at least 3");
  }
}

/// How many of the points are one and the same, if it may be most of them (the vote of Boyer and
/// Moore); else fewer than half.
Index most_repeats(const Points& points) {
  Index candidate = 0;
  Index votes = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (votes == 0) candidate = i;
    votes += points.col(i) == points.col(candidate) ? 1 : -1;
  }
  Index count = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    count += points.col(i) == points.col(candidate) ? 1 : 0;
  }
  return count;
}

/// Leaves the rows that are points, and says what the others were.
Cloud cloud_of(const std::filesystem::path& path, const PointsRef& points, bool is_organised,
               std::vector<std::string> notes) {
  if (points.cols() == 0) throw IoError(path, 0, "no finite point: no points at all");
  const ValidRows valid = valid_rows(points, is_organised);
  if (valid.indices.empty()) {
    throw IoError(path, 0,
                  "no finite point among " + std::to_string(points.cols()) +
                      (valid.num_zeros > 0 ? " that is not (0, 0, 0)" : ""));
  }
  const Index num_bad = valid.num_not_finite + valid.num_far;
  if (num_bad > 0) {
    notes.push_back("dropped " + std::to_string(num_bad) + " points that are not finite" +
                    (valid.num_far > 0 ? ", or a billion times as far as the others" : ""));
  }
  if (valid.num_zeros > 0) {
    notes.push_back("dropped " + std::to_string(valid.num_zeros) +
                    " points at (0, 0, 0), which mark no return");
  }
  Points kept = points(Eigen::all, valid.indices);
  const Index repeats = most_repeats(kept);
  if (repeats > 1 && 2 * repeats > kept.cols()) {
    notes.push_back(std::to_string(repeats) + " of " + std::to_string(kept.cols()) +
                    " points are one and the same");
  }
  return {std::move(kept), num_bad + valid.num_zeros, std::move(notes)};
}

/// Points on the surface of a mesh.
Cloud sample(const std::filesystem::path& path, CloudFile& file, Index num_points) {
  const Mesh mesh{std::move(file.points), std::move(file.triangles)};
  Points points = sample_surface(mesh, num_points);
  if (points.cols() == 0) {
    file.notes.push_back("a mesh of no area: its vertices are taken");
    return cloud_of(path, mesh.vertices, false, std::move(file.notes));
  }
  file.notes.push_back("a mesh of " + std::to_string(mesh.triangles.size()) +
                       " triangles: " + std::to_string(num_points) +
                       " points are spread over its surface (mesh_points 0 takes the vertices)");
  return {std::move(points), 0, std::move(file.notes)};
}

}  // namespace

CloudFile read_cloud_file(const std::filesystem::path& path, const CloudOptions& options) {
  check(options);
  const std::string extension = extension_of(path);
  const std::vector<std::string> known = cloud_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw IoError(path, 0, unknown_extension(extension, known));
  }
  CloudFile file = parse(path, extension, read_file(path), options);
  if (file.triangles.empty()) return file;
  const double share = share_of_corners({file.points, file.triangles});
  if (share < kLeastShareOfCorners) {
    file.notes.push_back("its faces use " +
                         std::to_string(static_cast<int>(std::lround(100 * share))) +
                         " % of the points: taken as a cloud, without them");
    file.triangles.clear();
  }
  return file;
}

namespace {

/// Magnitude from which on a coordinate is none, such as the largest float: a billion times that of
/// most of the rows.
double far_magnitude(const PointsRef& points, const std::vector<Index>& rows) {
  constexpr double kFarShare = 1e9;
  std::vector<double> magnitudes;
  magnitudes.reserve(rows.size());
  for (const Index i : rows) magnitudes.push_back(points.col(i).cwiseAbs().maxCoeff());
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  const bool is_known = middle != magnitudes.end() && *middle > 0;
  return is_known ? kFarShare * *middle : std::numeric_limits<double>::infinity();
}

}  // namespace

ValidRows valid_rows(const PointsRef& points, bool is_organised) {
  ValidRows valid;
  const auto is_zero = [&](Index i) { return (points.col(i).array() == 0).all(); };
  for (Index i = 0; i < points.cols(); ++i) valid.num_zeros += is_zero(i) ? 1 : 0;
  constexpr Index kFewZeros = 10;
  const bool marks = is_organised || valid.num_zeros > kFewZeros;
  if (!marks) valid.num_zeros = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (!points.col(i).allFinite()) {
      ++valid.num_not_finite;
    } else if (!marks || !is_zero(i)) {
      valid.indices.push_back(i);
    }
  }
  const double far = far_magnitude(points, valid.indices);
  valid.num_far = static_cast<Index>(std::erase_if(
      valid.indices, [&](Index i) { return points.col(i).cwiseAbs().maxCoeff() >= far; }));
  return valid;
}

}  // namespace io

std::vector<std::string> cloud_extensions() {
  return {".ply", ".pcd", ".xyz", ".xyzn",    ".xyzrgb", ".txt", ".asc", ".pts",
          ".csv", ".npy", ".bin", ".pcd.bin", ".obj",    ".off", ".stl"};
}

Cloud read_cloud(const std::filesystem::path& path, const CloudOptions& options) {
  io::CloudFile file = io::read_cloud_file(path, options);
  if (!file.triangles.empty() && options.mesh_points > 0) {
    return io::sample(path, file, options.mesh_points);
  }
  if (!file.triangles.empty()) file.notes.push_back("a mesh: its vertices are taken");
  return io::cloud_of(path, file.points, file.records.height > 1, std::move(file.notes));
}

}  // namespace gmcr
