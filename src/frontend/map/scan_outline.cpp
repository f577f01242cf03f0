#include "frontend/map/scan_outline.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "frontend/map/structure_grid.hpp"
#include "geometry/angles.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kGroundAround = 40;  // voxels about the sensor
constexpr double kGroundCell = 4;     // voxels
constexpr double kKernel = 1;         // voxels
constexpr int kRounds = 15;
constexpr double kFarthest = StructureGrid::kCell * (StructureGrid::kMargin - 4);

/// Key of a cell and band.
std::array<int, 3> key_of(const OutlinePoint& point) {
  return {static_cast<int>(std::floor(point.x / StructureGrid::kCell)),
          static_cast<int>(std::floor(point.y / StructureGrid::kCell)), point.band};
}

/// The lowest voxel of each cell about the sensor.
Points lowest_about(const Points& level) {
  std::map<std::array<int, 2>, Index> lowest;
  for (Index i = 0; i < level.cols(); ++i) {
    if (level.col(i).head<2>().norm() > kGroundAround) continue;
    const std::array<int, 2> cell{static_cast<int>(std::floor(level(0, i) / kGroundCell)),
                                  static_cast<int>(std::floor(level(1, i) / kGroundCell))};
    const auto [known, is_new] = lowest.emplace(cell, i);
    if (!is_new && level(2, i) < level(2, known->second)) known->second = i;
  }
  std::vector<Index> columns;
  for (const auto& [cell, i] : lowest) columns.push_back(i);
  return level(Eigen::all, columns);
}

/// A plane by least squares with the weights of Geman and McClure, about the lower ones of what is
/// lowest: what stands in a cell is above it, never below.
GroundPlane fit_ground(const Points& lowest) {
  GroundPlane plane;
  if (lowest.cols() == 0) return plane;
  Eigen::VectorXd heights = lowest.row(2);
  const Index low = heights.size() / 4;
  std::nth_element(heights.data(), heights.data() + low, heights.data() + heights.size());
  plane.c = heights[low];
  for (int round = 0; round < kRounds; ++round) {
    const double kernel = kKernel * std::max(1.0, 3 - 0.3 * round);
    Eigen::Matrix3d normal = 1e-3 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (Index i = 0; i < lowest.cols(); ++i) {
      const Eigen::Vector3d row(lowest(0, i), lowest(1, i), 1);
      const double residual = lowest(2, i) - plane.height(row.x(), row.y());
      const double root = kernel * kernel / (kernel * kernel + residual * residual);
      normal += root * root * row * row.transpose();
      right += root * root * residual * row;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    plane.a += step.x(), plane.b += step.y(), plane.c += step.z();
  }
  return plane;
}

/// One of each cell and band, in ascending order of the range.
std::vector<OutlinePoint> distinct(const std::vector<OutlinePoint>& points) {
  std::map<std::array<int, 3>, std::size_t> seen;
  std::vector<OutlinePoint> kept;
  for (const OutlinePoint& point : points) {
    if (seen.emplace(key_of(point), kept.size()).second) kept.push_back(point);
  }
  const auto range = [](const OutlinePoint& p) { return p.x * p.x + p.y * p.y; };
  std::stable_sort(kept.begin(), kept.end(), [&](const OutlinePoint& a, const OutlinePoint& b) {
    return range(a) < range(b);
  });
  return kept;
}

}  // namespace

Eigen::Matrix3d level_rotation(const Eigen::Vector3d& up) {
  return geometry::turn_between(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

ScanOutline outline_of(const Points& voxels, const Eigen::Vector3d& up) {
  ScanOutline outline;
  const Eigen::Matrix3d upright = level_rotation(up);
  const GroundPlane ground = fit_ground(lowest_about(upright * voxels));
  outline.level_from_scan = level_rotation(ground.up()) * upright;
  const Points level = outline.level_from_scan * voxels;
  outline.sensor_height = -ground.c * ground.up().z();
  std::vector<OutlinePoint> structure;
  for (Index i = 0; i < level.cols(); ++i) {
    const Eigen::Vector3d point = level.col(i);
    const int band = StructureGrid::band(point.z() + outline.sensor_height);
    if (band < 0 || point.head<2>().norm() > kFarthest) continue;
    structure.push_back({point.x(), point.y(), band});
  }
  outline.structure = distinct(structure);
  return outline;
}

}  // namespace gmcr::frontend
