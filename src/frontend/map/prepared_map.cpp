#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "frontend/alignment/centred_pair.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/features/prepared_file.hpp"
#include "frontend/map/level_frame.hpp"
#include "frontend/map/map_state.hpp"
#include "frontend/points/extent.hpp"
#include "geometry/angles.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/localisation.hpp"

namespace gmcr {
namespace {

constexpr double kPointsOfVoxel = 16;
constexpr double kFirstShare = 1.0 / 1024;  // of the extent
constexpr int kMostSteps = 16;

/// A size at which a voxel has so many points on average, sought from below.
double voxel_size_of(const PointsRef& points) {
  const double extent = frontend::robust_extent(points);
  if (!(extent > 0)) return 1;
  double size = kFirstShare * extent;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto num_voxels = static_cast<double>(voxel_grid(points, size).cols());
    const double points_of_voxel = static_cast<double>(points.cols()) / num_voxels;
    if (points_of_voxel >= kPointsOfVoxel) break;
    // of a surface the number grows with the square of the size
    size *= std::clamp(std::sqrt(kPointsOfVoxel / points_of_voxel), 1.05, 2.0);
  }
  return size;
}

std::vector<Index> all_columns(Index count) {
  std::vector<Index> columns(static_cast<std::size_t>(count));
  std::iota(columns.begin(), columns.end(), Index{0});
  return columns;
}

Eigen::Vector3d unit(const Eigen::Vector3d& up) {
  if (!up.allFinite() || !(up.norm() > 0)) throw InvalidOption("up", "it is no direction");
  return up.normalized();
}

}  // namespace

namespace frontend {

MapState::MapState(Points fine_voxels, Index given, double voxel, const Eigen::Vector3d& upward,
                   int num_threads)
    : fine(std::move(fine_voxels)),
      num_given(given),
      voxel_size(voxel),
      up(upward),
      voxels(voxel_grid(fine, voxel)),
      centre(centroid(voxels)),
      level_from_map(level_rotation(up)),
      surface(std::make_shared<SurfaceCloud>(voxels, centre, voxel)),
      grid(level_from_map * (voxels.colwise() - centre) / voxel),
      places(grid) {
  surface->require_normals(all_columns(voxels.cols()), num_threads);
}

Eigen::Vector3d MapState::level(const Eigen::Vector3d& point) const {
  return level_from_map * (point - centre) / voxel_size;
}

Similarity MapState::pose_at(const Place& place, const ScanOutline& outline,
                             const Eigen::Vector3d& viewpoint, double scale) const {
  const Eigen::Vector3d sensor(place.x, place.y, place.ground + outline.sensor_height);
  Similarity pose;
  pose.scale = scale;
  pose.rotation = level_from_map.transpose() *
                  geometry::turn_about(Eigen::Vector3d::UnitZ(), place.heading) *
                  outline.level_from_scan;
  pose.translation = centre + voxel_size * (level_from_map.transpose() * sensor) -
                     scale * (pose.rotation * viewpoint);
  return pose;
}

}  // namespace frontend

PreparedMap::PreparedMap(std::shared_ptr<const frontend::MapState> state)
    : state_(std::move(state)) {}

PreparedMap::PreparedMap(const PointsRef& points, const FrontendOptions& frontend,
                         const Eigen::Vector3d& up, int num_threads) {
  Options solver;
  solver.num_threads = num_threads;
  frontend::validate_pair(points, Points(3, 0), frontend, solver);
  if (points.cols() == 0) throw std::invalid_argument("map: it has no points");
  const double voxel = frontend.voxel_size > 0 ? frontend.voxel_size : voxel_size_of(points);
  state_ = std::make_shared<frontend::MapState>(voxel_grid(points, voxel / 2), points.cols(), voxel,
                                                unit(up), num_threads);
}

const Points& PreparedMap::points() const { return state_->fine; }
double PreparedMap::voxel_size() const { return state_->voxel_size; }
const Eigen::Vector3d& PreparedMap::up() const { return state_->up; }

std::string PreparedMap::to_bytes() const {
  const FrontendOptions radii;
  return frontend::write_prepared({state_->fine,
                                   state_->voxel_size,
                                   radii.normal_radius,
                                   radii.feature_radius,
                                   radii.source_viewpoint,
                                   {},
                                   state_->num_given});
}

PreparedMap PreparedMap::from_bytes(std::string_view bytes, const Eigen::Vector3d& up,
                                    int num_threads) {
  frontend::PreparedFile file = frontend::read_prepared(bytes);
  FrontendOptions options;
  options.voxel_size = file.voxel_size;
  Options solver;
  solver.num_threads = num_threads;
  frontend::validate_pair(file.points, Points(3, 0), options, solver);
  if (file.points.cols() == 0 || !(file.voxel_size > 0)) {
    throw std::invalid_argument("map: it has no points or no voxel size");
  }
  const bool is_cloud = !file.surfaces.empty();  // whose points are not on voxels yet
  Points fine = is_cloud ? voxel_grid(file.points, file.voxel_size / 2) : std::move(file.points);
  return PreparedMap(std::make_shared<frontend::MapState>(std::move(fine), file.num_given,
                                                          file.voxel_size, unit(up), num_threads));
}

}  // namespace gmcr
