#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/io.hpp"
#include "io/clouds/records.hpp"
#include "io/meshes/mesh.hpp"

namespace gmcr::io {

/// Everything that a file says of a cloud or a mesh.
struct CloudFile {
  Points points;                    ///< of all rows, finite or not
  std::vector<Triangle> triangles;  ///< of a mesh, between the points
  Records records;                  ///< of PLY and PCD: the rows with all their fields
  std::vector<std::string> notes;
};

/// Reads a file by its extension.
/// @throws IoError.
CloudFile read_cloud_file(const std::filesystem::path& path, const CloudOptions& options);

/// Whether an extension, as of `extension_of`, is one of text tables.
bool is_text_table(std::string_view extension);

/// Points of a text table: columns by the names of its header, else the first three. Tables of
/// `.csv` have exactly three then; a first column that may be an index is refused.
CloudFile parse_text_cloud(const std::filesystem::path& path, std::string_view text, bool is_csv);

/// Points of rows of float32, of which a point has `num_columns`, x, y, z first.
CloudFile parse_binary_scan(const std::filesystem::path& path, std::string_view bytes,
                            Index num_columns);

/// As `parse_binary_scan`; the number of columns is chosen by the size and by what the columns
/// hold.
CloudFile parse_unknown_scan(const std::filesystem::path& path, std::string_view bytes);

/// Rows of a cloud that are points: finite, not the (0, 0, 0) that sensors write for no return, and
/// not a billion times as far as the median, as the largest float is.
struct ValidRows {
  std::vector<Index> indices;
  Index num_not_finite = 0;
  Index num_far = 0;
  Index num_zeros = 0;
};

/// (0, 0, 0) marks no return in an organised cloud, and where it is there more than ten times.
ValidRows valid_rows(const PointsRef& points, bool is_organised);

/// Whether rounding to float32 moves no finite point by more than a millionth of the extent, which
/// is a ten-thousandth of a voxel of a hundredth of the extent.
bool float32_suffices(const PointsRef& points);

/// The rows moved by `pose`, normals turned with it; rows that are no points stay as they are.
/// Coordinates are float32 where the file had them so and that suffices, else float64.
Records moved(const Records& records, const PointsRef& points, const Similarity& pose);

}  // namespace gmcr::io
