#include <algorithm>
#include <cmath>
#include <limits>

#include "gmcr/io.hpp"
#include "io/clouds/cloud_file.hpp"
#include "io/clouds/npy.hpp"
#include "io/clouds/pcd.hpp"
#include "io/clouds/ply.hpp"
#include "io/file.hpp"
#include "io/tables/table.hpp"
#include "io/tables/text.hpp"

namespace gmcr {
namespace io {
namespace {

/// Text without a header.
bool is_plain_text(const std::string& extension) {
  return extension == ".xyz" || extension == ".txt" || extension == ".asc";
}

/// Points of PCD: float32, the only coordinates that PCL and Open3D read, where that suffices.
Records pcd_records(const PointsRef& points) {
  Records records = records_of(points);
  if (!float32_suffices(points)) return records;
  for (Field& field : records.fields) field.type = Scalar::Float32;
  records.bytes.clear();
  for (Index i = 0; i < points.cols(); ++i) {
    for (Index j = 0; j < 3; ++j) append_scalar(records.bytes, Scalar::Float32, points(j, i));
  }
  return records;
}

std::string format(const std::filesystem::path& path, const PointsRef& points) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return format_ply(records_of(points), {});
  if (extension == ".pcd") return format_pcd(pcd_records(points));
  if (extension == ".csv") return format_rows(points, ',', "x,y,z\n");
  if (extension == ".npy") return format_npy(points);
  if (is_plain_text(extension)) return format_rows(points, ' ', "");
  throw IoError(path, 0, unknown_extension(extension, written_cloud_extensions()));
}

/// The new numbers of a row at three of its fields.
struct Replacement {
  std::array<std::size_t, 3> fields;
  Points values;
};

/// The value that a replacement has for a field of a row, or nullptr.
const double* value_of(const std::vector<Replacement>& replacements, std::size_t field, Index row) {
  for (const Replacement& replacement : replacements) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (replacement.fields[axis] == field) {
        return &replacement.values(static_cast<Index>(axis), row);
      }
    }
  }
  return nullptr;
}

/// The records with other numbers at some fields, whose types are those of `types`.
Records replace(const Records& records, const std::vector<Replacement>& replacements,
                const std::vector<Scalar>& types) {
  Records result{records.fields, records.num_rows, records.height, ""};
  for (std::size_t i = 0; i < types.size(); ++i) result.fields[i].type = types[i];
  result.bytes.reserve(static_cast<std::size_t>(records.num_rows) * row_bytes(result.fields));
  const char* at = records.bytes.data();
  for (Index row = 0; row < records.num_rows; ++row) {
    for (std::size_t i = 0; i < records.fields.size(); ++i) {
      const std::size_t size = size_of(records.fields[i].type) * records.fields[i].count;
      if (const double* value = value_of(replacements, i, row)) {
        append_scalar(result.bytes, types[i], *value);
      } else {
        result.bytes.append(at, size);
      }
      at += size;
    }
  }
  return result;
}

}  // namespace

bool float32_suffices(const PointsRef& points) {
  constexpr double kLargestShare = 1e-6;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  double largest = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (!points.col(i).allFinite()) continue;
    low = low.cwiseMin(points.col(i));
    high = high.cwiseMax(points.col(i));
    for (Index j = 0; j < 3; ++j) {
      const double rounded = static_cast<float>(points(j, i));
      largest = std::max(largest, std::abs(rounded - points(j, i)));
    }
  }
  return largest == 0 || largest <= kLargestShare * (high - low).norm();
}

Records moved(const Records& records, const PointsRef& points, const Similarity& pose) {
  std::vector<Scalar> types;
  for (const Field& field : records.fields) types.push_back(field.type);
  std::vector<Replacement> replacements;
  const auto coordinates = find_coordinates(records.fields);
  const std::vector<Index> valid = valid_rows(points, records.height > 1).indices;
  Points values = points;
  for (const Index i : valid) values.col(i) = pose.apply(Points(points.col(i)));
  const bool suffices = float32_suffices(Points(values(Eigen::all, valid)));
  replacements.push_back({coordinates, std::move(values)});
  for (const std::size_t field : coordinates) {
    if (types[field] != Scalar::Float32 || !suffices) types[field] = Scalar::Float64;
  }
  const auto normal = find_normal(records.fields);
  if (normal && std::all_of(normal->begin(), normal->end(),
                            [&](std::size_t field) { return is_float(types[field]); })) {
    replacements.push_back({*normal, pose.rotation * columns_of(records, *normal)});
  }
  return replace(records, replacements, types);
}

}  // namespace io

void write_cloud(const std::filesystem::path& path, const PointsRef& points) {
  io::write_file(path, io::format(path, points));
}

void write_moved_cloud(const std::filesystem::path& path, const std::filesystem::path& source,
                       const Similarity& pose, const CloudOptions& options) {
  const std::string extension = io::extension_of(path);
  const bool is_ply = extension == ".ply";
  if (is_ply || extension == ".pcd") {
    const io::CloudFile file = io::read_cloud_file(source, options);
    const bool is_mesh = !file.triangles.empty();
    const bool keeps = is_mesh ? is_ply : !file.records.fields.empty();
    if (keeps) {
      const io::Records& records =
          file.records.fields.empty() ? io::records_of(file.points) : file.records;
      const io::Records result = io::moved(records, file.points, pose);
      return io::write_file(
          path, is_ply ? io::format_ply(result, file.triangles) : io::format_pcd(result));
    }
  }
  write_cloud(path, pose.apply(read_cloud(source, options).points));
}

void check_cloud_output(const std::filesystem::path& path) {
  const std::string extension = io::extension_of(path);
  const std::vector<std::string> known = written_cloud_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw IoError(path, 0, io::unknown_extension(extension, known));
  }
  check_output(path);
}

std::vector<std::string> written_cloud_extensions() {
  return {".ply", ".pcd", ".xyz", ".txt", ".asc", ".csv", ".npy"};
}

}  // namespace gmcr
