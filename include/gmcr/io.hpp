#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr {

/// A file that cannot be read or written; `what()` is "path:line: reason", or "path: reason".
class IoError : public std::runtime_error {
 public:
  /// @param line  counted from 1; 0 where the error belongs to no line.
  IoError(const std::filesystem::path& path, std::size_t line, const std::string& reason);

  const std::filesystem::path& path() const { return path_; }
  std::size_t line() const { return line_; }
  const std::string& reason() const { return reason_; }

 private:
  std::filesystem::path path_;
  std::size_t line_;
  std::string reason_;
};

/// A cloud as it was read.
struct Cloud {
  Points points;          ///< 3 x N, N >= 1, finite, in the order of the file, its units
  Index num_dropped = 0;  ///< points of the file that had a coordinate that is not finite
};

/// Putative correspondences: source.col(i) -> target.col(i).
struct Matches {
  Points source;
  Points target;
  std::vector<double> noise_bounds;  ///< metres, one a correspondence, or empty: not in the file
};

/// Reads a point cloud; the extension, in any case, says the format:
/// `.ply`, `.pcd` (ascii, binary, binary_compressed); `.xyz`, `.pts` (text, further columns are
/// ignored); `.csv` (columns x, y, z by name, or exactly 3; comma, semicolon or white space);
/// `.npy` ((N, 3), float32 or float64, little-endian, C or Fortran order);
/// `.pcd.bin` (nuScenes, 5 float32 a point); `.bin` (KITTI, 4 float32 a point).
/// Numbers do not depend on the locale.
/// @throws IoError where the file is missing, empty, truncated, of another format, or without a
///   finite point. Nothing is printed.
Cloud read_cloud(const std::filesystem::path& path);

/// Writes `points` (3 x N) as `.ply` (binary float64), `.xyz`, `.csv` or `.npy` (float64), which
/// read back as the same bits, or as `.pcd` in float32, the only coordinates that PCL and Open3D
/// read.
/// @throws IoError where the extension is unknown or the file cannot be written.
void write_cloud(const std::filesystem::path& path, const PointsRef& points);

/// Reads correspondences from `.csv` or `.npy` ((N, 6) or (N, 7)). Row i of the data is
/// correspondence i, N may be 0 where a header or the shape says what the columns are.
///
/// A CSV without a header has exactly 6 or 7 columns: source x, y, z, target x, y, z and, if there
/// is one, the noise bound of the correspondence, metres, > 0. A header may name the columns
/// ax..bz, sx..tz, source_x..target_z or src_x..dst_z and noise_bound (also bound or beta), in any
/// case and order and among others, which are ignored; a header with other names needs exactly 6
/// columns beside the noise bound.
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
