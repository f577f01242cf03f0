#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// Vertices of a triangle, counted from 0.
using Triangle = std::array<Index, 3>;

/// A surface; without triangles it is a cloud.
struct Mesh {
  Points vertices;
  std::vector<Triangle> triangles;
};

/// Adds the triangles of a polygon, as a fan around its first corner; fewer than 3 corners are
/// none.
void add_polygon(std::vector<Triangle>& triangles, const std::vector<Index>& corners);

/// Adds the triangles of strips, which a negative corner ends; every other one is turned around, so
/// that all face the same side.
void add_strips(std::vector<Triangle>& triangles, const std::vector<Index>& corners);

/// Wavefront OBJ: `v` and `f` (from 1, or from the end where negative; further indices and
/// statements are skipped).
/// @throws IoError with the line. The same holds for the others here.
Mesh parse_obj(const std::filesystem::path& path, std::string_view text);

/// Object file format as text: OFF, COFF, NOFF, STOFF and their sums.
Mesh parse_off(const std::filesystem::path& path, std::string_view text);

/// Stereolithography, as text or binary, told apart by size; each triangle brings its own vertices.
Mesh parse_stl(const std::filesystem::path& path, std::string_view bytes);

/// Share of the vertices that are corners of a triangle, 0 to 1.
double share_of_corners(const Mesh& mesh);

/// Points spread evenly over the surface: each stands for the same area, on a triangle they follow
/// a low-discrepancy sequence. No points where no triangle has an area. Deterministic. Cost:
/// O(triangles + num_points).
Points sample_surface(const Mesh& mesh, Index num_points);

}  // namespace gmcr::io
