#include <Eigen/Geometry>
#include <cmath>

#include "io/meshes/mesh.hpp"

namespace gmcr::io {
namespace {

/// Twice the area; 0 where a corner is not finite.
double doubled_area(const Mesh& mesh, const Triangle& triangle) {
  const Eigen::Vector3d a = mesh.vertices.col(triangle[0]);
  const double area = (mesh.vertices.col(triangle[1]) - a)
                          .cross(Eigen::Vector3d(mesh.vertices.col(triangle[2]) - a))
                          .norm();
  return std::isfinite(area) ? area : 0;
}

/// The i-th point of the R2 sequence (Roberts 2018) in a triangle, from its centroid on.
Eigen::Vector3d point_in(const Mesh& mesh, const Triangle& triangle, Index i) {
  constexpr double kStepU = 0.7548776662466927;
  constexpr double kStepV = 0.5698402909980532;
  const auto fraction = [](double value) { return value - std::floor(value); };
  double u = fraction(1.0 / 3 + kStepU * static_cast<double>(i));
  double v = fraction(1.0 / 3 + kStepV * static_cast<double>(i));
  if (u + v > 1) {  // the other half of the square
    u = 1 - u;
    v = 1 - v;
  }
  const Eigen::Vector3d a = mesh.vertices.col(triangle[0]);
  return a + u * (mesh.vertices.col(triangle[1]) - a) + v * (mesh.vertices.col(triangle[2]) - a);
}

}  // namespace

void add_polygon(std::vector<Triangle>& triangles, const std::vector<Index>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

void add_strips(std::vector<Triangle>& triangles, const std::vector<Index>& corners) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] < 0) start = i + 1;
    if (i < start + 2) continue;
    const bool is_turned = (i - start) % 2 == 1;
    triangles.push_back(
        {corners[i - 2], corners[is_turned ? i : i - 1], corners[is_turned ? i - 1 : i]});
  }
}

double share_of_corners(const Mesh& mesh) {
  std::vector<bool> is_corner(static_cast<std::size_t>(mesh.vertices.cols()));
  Index num_corners = 0;
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index corner : triangle) {
      auto known = is_corner[static_cast<std::size_t>(corner)];
      if (!known) ++num_corners;
      known = true;
    }
  }
  return mesh.vertices.cols() == 0
             ? 0
             : static_cast<double>(num_corners) / static_cast<double>(mesh.vertices.cols());
}

Points sample_surface(const Mesh& mesh, Index num_points) {
  double total = 0;
  for (const Triangle& triangle : mesh.triangles) total += doubled_area(mesh, triangle);
  if (!(total > 0) || !std::isfinite(total)) return {};
  Points points(3, num_points);
  const double share = total / static_cast<double>(num_points);
  double passed = 0;  // area of the triangles so far
  Index next = 0;
  Index last = 0;  // the last triangle with an area takes what rounding left over
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = doubled_area(mesh, mesh.triangles[t]);
    if (area == 0) continue;
    last = static_cast<Index>(t);
    passed += area;
    for (Index i = 0; next < num_points && (static_cast<double>(next) + 0.5) * share < passed;
         ++i) {
      points.col(next++) = point_in(mesh, mesh.triangles[t], i);
    }
  }
  for (Index i = 0; next < num_points; ++i) {
    points.col(next++) = point_in(mesh, mesh.triangles[static_cast<std::size_t>(last)], i);
  }
  return points;
}

}  // namespace gmcr::io
