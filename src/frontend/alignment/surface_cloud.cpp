#include "frontend/alignment/surface_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/plane_normal.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

/// Nearest points that span the plane of a point, itself among them: on voxels those within about
/// two, so that edges stay sharp.
constexpr std::size_t kPlanePoints = 10;
/// Spacings: reach of the grid, a little above the widest search of an alignment. A disc of it has
/// about 28 points.
constexpr double kReach = 3.05;

/// Share of the reach within which kPlanePoints mostly are, sought first.
constexpr double kFirstShare = 0.67;

/// Queries of a thread at a time: fewer take less time than to wake one.
constexpr Index kNormalGrain = 256;
/// Powers of sqrt(3) by which each grid reaches farther than the one before, for points that have
/// few nearby.
constexpr int kFarther = 2;

}  // namespace

SurfaceCloud::SurfaceCloud(const PointsRef& points, const Eigen::Vector3d& centre, double spacing)
    : points_(points.colwise() - centre),
      grid_(points_, kReach * spacing),
      normals_(Points::Zero(3, points.cols())),
      is_known_(static_cast<std::size_t>(points.cols()), 0) {}

const PointGrid& SurfaceCloud::wider(int k) {
  if (k == 0) return grid_;
  const auto known = wider_.find(k);
  if (known != wider_.end()) return known->second;
  double reach = grid_.reach();
  for (int power = 0; power < k; ++power) reach *= std::numbers::sqrt3;
  return wider_.try_emplace(k, points_, reach).first->second;
}

std::vector<Index> SurfaceCloud::nearest(const PointsRef& queries, double radius, int num_threads) {
  const PointGrid& grid = [&]() -> const PointGrid& {
    if (radius <= grid_.reach()) return grid_;
    int power = 0;
    for (double reach = grid_.reach(); reach < radius; ++power) reach *= std::numbers::sqrt3;
    const std::scoped_lock lock(mutex_);
    return wider(power);
  }();
  const kernels::PointColumns columns = grid.columns();
  // a point at the radius itself is one
  const double squared_radius =
      std::nextafter(radius * radius, std::numeric_limits<double>::infinity());
  std::vector<Index> found(static_cast<std::size_t>(queries.cols()), -1);
  parallel::parallel_for(queries.cols(), kNormalGrain, num_threads, [&](Index begin, Index end) {
    PointGrid::Runs runs;
    for (Index i = begin; i < end; ++i) {
      const double* query = queries.col(i).data();
      const kernels::NearestPoint nearest = kernels::nearest_point(
          columns, grid.runs_within(query, radius, runs), query, squared_radius);
      if (nearest.index >= 0) found[static_cast<std::size_t>(i)] = grid.point(nearest.index);
    }
  });
  return found;
}

void SurfaceCloud::require_normals(const std::vector<Index>& columns, int num_threads) {
  const std::scoped_lock lock(mutex_);
  std::vector<Index> missing;
  for (const Index column : columns) {
    if (column < 0 || is_known_[static_cast<std::size_t>(column)]) continue;
    is_known_[static_cast<std::size_t>(column)] = 1;
    missing.push_back(column);
  }
  for (int power = 0; !missing.empty(); power += kFarther) {
    const PointGrid& grid = wider(power);
    std::vector<char> is_left(missing.size(), 0);
    parallel::parallel_for(
        static_cast<Index>(missing.size()), 64, num_threads, [&](Index begin, Index end) {
          Found found;
          for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
            const auto normal = estimate_normal(grid, missing[k], found);
            is_left[k] = !normal;
            if (normal) normals_.col(missing[k]) = *normal;
          }
        });
    std::vector<Index> left;
    for (std::size_t k = 0; k < missing.size(); ++k) {
      if (is_left[k]) left.push_back(missing[k]);
    }
    missing = std::move(left);
  }
}

std::size_t SurfaceCloud::find_near(const PointGrid& grid, Index i, double radius,
                                    Found& found) const {
  const double* query = points_.col(i).data();
  PointGrid::Runs within;
  const auto runs = grid.runs_within(query, radius, within);
  const auto room =
      static_cast<std::size_t>(PointGrid::num_points(runs) + kernels::NearPoints::kSlack);
  if (room > found.slots.size()) {
    found.slots.resize(room);
    found.squared_distances.resize(room);
  }
  return static_cast<std::size_t>(
      kernels::near_points(grid.columns(), runs, query, radius * radius,
                           {found.slots.data(), found.squared_distances.data()}));
}

std::optional<Eigen::Vector3d> SurfaceCloud::estimate_normal(const PointGrid& grid, Index i,
                                                             Found& found) const {
  const auto wanted = std::min(kPlanePoints, static_cast<std::size_t>(size()));
  std::size_t count = find_near(grid, i, kFirstShare * grid.reach(), found);
  if (count < wanted) count = find_near(grid, i, grid.reach(), found);
  if (count < wanted) return std::nullopt;
  if (wanted < 3) return Eigen::Vector3d::Zero();
  // the nearest so far, in order; of those that tie the first found
  std::array<std::pair<double, std::int64_t>, kPlanePoints> nearest;
  std::size_t num_nearest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double squared = found.squared_distances[k];
    if (num_nearest == wanted && squared >= nearest[wanted - 1].first) continue;
    std::size_t at = num_nearest < wanted ? num_nearest++ : wanted - 1;
    for (; at > 0 && nearest[at - 1].first > squared; --at) nearest[at] = nearest[at - 1];
    nearest[at] = {squared, found.slots[k]};
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < wanted; ++k) {
    const Eigen::Vector3d offset = points_.col(grid.point(nearest[k].second)) - points_.col(i);
    sum += offset;
    outer += offset * offset.transpose();
  }
  const auto total = static_cast<double>(wanted);
  return geometry::plane_normal(outer / total - sum * sum.transpose() / (total * total));
}

}  // namespace gmcr::frontend
