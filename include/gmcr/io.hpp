#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// A file that cannot be read or written; `what()` is "path:line: reason", or "path: reason".
class IoError : public std::runtime_error {
 public:
  /// @param line  counted from 1; 0 where the error belongs to no line.
  IoError(const std::filesystem::path& path, std::size_t line, const std::string& reason);

  const std::filesystem::path& path() const { return path_; }  ///< of the file
  std::size_t line() const { return line_; }                   ///< from 1; 0: of no line
  const std::string& reason() const { return reason_; }        ///< without path and line

 private:
  std::filesystem::path path_;
  std::size_t line_;
  std::string reason_;
};

/// How a file of a cloud is read where it leaves a choice.
struct CloudOptions {
  /// Points to spread evenly over the surface of a mesh; 0: its vertices.
  Index mesh_points = 100000;
  /// Float32 numbers that a point of a `.bin` file has, at least 3; 0: told by the size of the file
  /// and by what its columns hold.
  Index bin_columns = 0;
};

/// A cloud as it was read.
struct Cloud {
  Points points;          ///< 3 x N, N >= 1, finite, in the order of the file, its units
  Index num_dropped = 0;  ///< points of the file that are not finite, too far or mark no return
  // NOLINTNEXTLINE(readability-redundant-member-init): so that callers may leave it out
  std::vector<std::string> notes{};  ///< what was dropped or had to be decided, as sentences
};

/// Putative correspondences: source.col(i) -> target.col(i).
struct Matches {
  Points source;                     ///< 3 x N, metres, source frame
  Points target;                     ///< 3 x N, metres, target frame
  std::vector<double> noise_bounds;  ///< metres, one a correspondence, or empty: not in the file
  // NOLINTNEXTLINE(readability-redundant-member-init): so that callers may leave it out
  std::vector<std::string> notes{};  ///< what had to be decided, as sentences
};

/// Reads a point cloud or a mesh; the extension, in any case, says the format, docs/files.md the
/// details:
/// `.ply` (every type, byte order and order of properties, lists); `.pcd` (ascii, binary,
/// binary_compressed; every type); `.xyz`, `.txt`, `.asc`, `.pts`, `.csv` (text tables, read by
/// what they hold: headers, counts, separators, decimal marks; further columns are ignored); `.npy`
/// ((N, 3) or, of more rows than columns, wider; floating or integer, C or Fortran order);
/// `.pcd.bin` (nuScenes, 5 float32 a point);
/// `.bin` (KITTI, 4 float32 a point, or 3, 5 or 6 where size and content say so); `.obj`, `.off`,
/// `.stl`, which like a `.ply` with faces are meshes: points are spread over their surface.
/// Numbers do not depend on the locale. Points that are not finite are dropped, and so is (0, 0, 0)
/// in organised clouds and where it is there more than ten times: sensors write it for no return;
/// so is what is a billion times as far as the median, such as the largest float.
/// @throws IoError where the file is missing, empty, cut, of another format, ambiguous, or without
///   a finite point; std::invalid_argument where an option is out of range. Nothing is printed.
/// Memory: a few times the size of the file, whatever its header promises.
Cloud read_cloud(const std::filesystem::path& path, const CloudOptions& options = {});

/// Extensions that `read_cloud` knows, with their dots.
std::vector<std::string> cloud_extensions();

/// Extensions that `write_cloud` knows.
std::vector<std::string> written_cloud_extensions();

/// Writes `points` (3 x N) as `.ply` (binary float64), `.xyz`, `.txt`, `.asc`, `.csv` or `.npy`
/// (float64), which read back as the same bits, or as `.pcd`: in float32, the only coordinates that
/// PCL and Open3D read, unless that would move a point by more than a millionth of the extent, then
/// in float64.
///
/// As all that is written here the file is whole or absent: it is written aside and takes its name
/// at the end, so that an error or a kill leaves an older file as it was.
/// @throws IoError where the extension is unknown or the file cannot be written.
void write_cloud(const std::filesystem::path& path, const PointsRef& points);

/// Writes the cloud of the file `source` after `pose`. From `.ply` and `.pcd` to these, all rows of
/// the file with all their fields (colour, intensity, ...): coordinates moved, in float32 where
/// they were and that suffices as for `write_cloud`, normals turned; rows that are no points stay
/// as they are. A mesh goes to `.ply` with its faces, as triangles. Else the points of
/// `read_cloud`.
/// @throws IoError as `read_cloud` and `write_cloud`.
void write_moved_cloud(const std::filesystem::path& path, const std::filesystem::path& source,
                       const Similarity& pose, const CloudOptions& options = {});

/// Refuses early what could not be written at the end.
/// @throws IoError where the folder is missing or not writable, or the path is a folder.
void check_output(const std::filesystem::path& path);

/// As `check_output`, and where `write_cloud` does not know the extension.
void check_cloud_output(const std::filesystem::path& path);

/// As `check_output`, and where `write_matches` does not know the extension.
void check_matches_output(const std::filesystem::path& path);

/// All bytes of a file.
/// @throws IoError where it is missing, a folder, unreadable or empty.
std::string read_bytes(const std::filesystem::path& path);

/// Writes a text, whole or not at all.
/// @throws IoError where the file cannot be written.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Reads correspondences from `.csv`, `.txt` or `.npy` ((N, 6) or (N, 7)). Row i of the data is
/// correspondence i, N may be 0 where a header or the shape says what the columns are.
///
/// A table without a header has exactly 6 or 7 columns: source x, y, z, target x, y, z and, if
/// there is one, the noise bound of the correspondence, metres, > 0. A seventh column without a
/// name that may as well be a score (ten rows or more, all in [0, 1] and one above 0.5, or one
/// above a tenth of the extent) is refused, and so are seven columns whose first may number the
/// matches (three rows or more of different whole numbers, beside columns of others). A header may
/// name the columns ax..bz, sx..tz, x1..z2, fixed_x..moving_z or the like and noise_bound (also
/// bound or beta), in any case and order and among others, which are ignored with a note; a header
/// with other names needs exactly 6 columns beside the noise bound and columns named score, weight
/// or the like, and a note says which are the source.
/// @throws IoError as `read_cloud`, and where a value is not finite or a bound not positive, since
///   a row cannot be dropped without renumbering the others.
Matches read_matches(const std::filesystem::path& path);

/// Writes correspondences (3 x N each, the same N) as `.csv` with the header ax,ay,az,bx,by,bz or
/// as `.npy` (N, 6); reading the file gives the same bits.
/// @param noise_bounds  N values, metres, > 0, finite, or empty. Where given they are a 7th column,
///   in the header noise_bound.
/// @throws IoError as `write_cloud`; std::invalid_argument where the sizes differ or a bound is not
///   positive and finite.
void write_matches(const std::filesystem::path& path, const PointsRef& source,
                   const PointsRef& target, std::span<const double> noise_bounds = {});

/// Reads a 4 x 4 row-major text file, target_from_source; `#` starts a comment line.
/// @throws IoError where it does not hold 16 numbers in rows of 4 that are a similarity to 1e-3.
Similarity read_transform(const std::filesystem::path& path);

/// Writes `transform` as 4 rows of 4 numbers with full precision.
/// @throws IoError where the file cannot be written.
void write_transform(const std::filesystem::path& path, const Similarity& transform);

/// Reads an undirected graph: DIMACS `.clq` or `.col` (`p edge N M` or `p col N M`, `e u v`), or
/// MatrixMarket `.mtx` (coordinate; real, integer or pattern; symmetric or general, which is
/// symmetrised). Vertices count from 1 in the file, from 0 in the graph; loops are ignored.
/// @param memory_limit  bytes that the graph may take.
/// @throws IoError with the line of the first error; also where the file ends early, or the graph
///   would take more than `memory_limit`.
BitsetGraph read_graph(const std::filesystem::path& path, std::size_t memory_limit);

/// Writes integers, one a line.
/// @throws IoError where the file cannot be written.
void write_indices(const std::filesystem::path& path, std::span<const Index> indices);

}  // namespace gmcr
