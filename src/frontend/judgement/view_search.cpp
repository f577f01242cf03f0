#include "frontend/judgement/view_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "frontend/points/extent.hpp"
#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {
namespace {

constexpr int kDirections = 20;
constexpr int kTurns = 12;  // about each direction
constexpr std::size_t kViewPoses = 6;
constexpr double kCoarse = 3;           // voxels: edge of the coarse ones
constexpr double kDistinct = 1.5;       // coarse voxels
constexpr std::size_t kWorthMore = 32;  // poses that are followed to the end
constexpr Index kMostVoxels = 16000;
/// A grid that leaves more than this share of the points apart is finer than their spacing.
constexpr double kSparseShare = 0.7;
constexpr double kLargest = 1.25;  // extent of a view over that of the object

/// Directions spread evenly over the sphere, along a spiral.
std::vector<Eigen::Vector3d> directions() {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> all;
  for (int k = 0; k < kDirections; ++k) {
    const double z = 1 - (2 * k + 1.0) / kDirections, r = std::sqrt(1 - z * z);
    all.emplace_back(r * elementary::cos(golden * k), r * elementary::sin(golden * k), z);
  }
  return all;
}

/// Mean of what is seen of the points from afar: of each column of cells along the direction what
/// lies within a cell and a half of its foremost point.
Eigen::Vector3d centre_of_view(const Points& points, const Eigen::Vector3d& direction,
                               double cell) {
  const Eigen::Vector3d across = direction.unitOrthogonal(), up = direction.cross(across);
  const auto cell_of = [&](const Eigen::Vector3d& p) {
    return std::pair(std::floor(across.dot(p) / cell), std::floor(up.dot(p) / cell));
  };
  std::map<std::pair<double, double>, double> foremost;
  for (const auto p : points.colwise()) {
    const auto [at, is_new] = foremost.try_emplace(cell_of(p), direction.dot(p));
    if (!is_new) at->second = std::max(at->second, direction.dot(p));
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (const auto p : points.colwise()) {
    if (direction.dot(p) < foremost.at(cell_of(p)) - 1.5 * cell) continue;
    sum += p;
    ++count;
  }
  return sum / count;
}

/// The object turned to the sensor from all around, what is seen of it about where the view lies.
std::vector<Similarity> starts_of(const Points& object, const Points& view, double cell,
                                  const Eigen::Vector3d& viewpoint, double scale) {
  const Eigen::Vector3d centre = view.rowwise().mean();
  const Eigen::Vector3d toward = (viewpoint - centre).normalized();
  std::vector<Similarity> starts;
  for (const Eigen::Vector3d& direction : directions()) {
    const Eigen::Vector3d seen = centre_of_view(object, direction, cell);
    const Eigen::Matrix3d turn = geometry::turn_between(direction, toward).toRotationMatrix();
    for (int k = 0; k < kTurns; ++k) {
      const double angle = 2 * std::numbers::pi * k / kTurns;
      Similarity start;
      start.scale = scale;
      start.rotation = geometry::turn_about(toward, angle) * turn;
      start.translation = centre - scale * (start.rotation * seen);
      starts.push_back(start);
    }
  }
  return starts;
}

void best_first(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.overlap > b.overlap; });
}

}  // namespace

double coarsening_of(const PointsRef& points, double voxel_size) {
  constexpr int kMostSteps = 6;
  double factor = 1;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto num_voxels = static_cast<double>(voxel_grid(points, factor * voxel_size).cols());
    if (num_voxels <= kSparseShare * static_cast<double>(points.cols())) break;
    factor *= std::numbers::sqrt2;
  }
  return factor;
}

bool may_show(const ObjectAndView& clouds, double scale) {
  if (clouds.object.cols() > kMostVoxels || clouds.view.cols() > 2 * kMostVoxels) return false;
  const double extent = robust_extent(clouds.view);
  const Eigen::Vector3d centre = clouds.view.rowwise().mean();
  return extent <= kLargest * scale * robust_extent(clouds.object) &&
         (clouds.viewpoint - centre).norm() > extent / 2;
}

std::vector<Similarity> poses_by_views(const ObjectAndView& clouds, const Options& options,
                                       const parallel::Deadline& deadline) {
  const double cell = kCoarse * clouds.voxel, scale = options.scale;
  const Points object = voxel_grid(clouds.object, cell / scale);
  const Points view = voxel_grid(clouds.view, cell);
  const auto pair =
      std::make_shared<CentredPair>(object, view, cell / scale, cell, options.num_threads);
  SurfaceJudge judge(pair, cell, options);
  std::vector<Similarity> starts = starts_of(object, view, cell / scale, clouds.viewpoint, scale);
  std::erase_if(starts, [&](const Similarity& start) { return !options.admit(start); });
  std::vector<Candidate> found = judge.peek(starts, deadline);
  best_first(found);
  found.resize(std::min(found.size(), kWorthMore));
  found = judge.glance(poses_of(found), deadline);
  best_first(found);
  std::vector<Similarity> poses;
  for (const Candidate& candidate : found) {
    const Similarity& pose = candidate.target_from_source;
    const bool is_new = std::all_of(poses.begin(), poses.end(), [&](const Similarity& other) {
      return judge.are_distinct(pose, other, kDistinct);
    });
    if (is_new) poses.push_back(pose);
    if (poses.size() == kViewPoses) break;
  }
  return poses;
}

}  // namespace gmcr::frontend
