#include "frontend/features/cloud_scales.hpp"

#include <algorithm>
#include <utility>

#include "frontend/points/extent.hpp"

namespace gmcr::frontend {
namespace {

/// Voxel over the extent of the cloud: fine enough for FPFH to see the shape, coarse enough for a
/// few thousand points.
constexpr double kVoxelShare = 0.015;

}  // namespace

double CloudScales::known_extent() {
  if (!extent_) extent_ = points_.cols() > 0 ? robust_extent(points_) : 0;
  return *extent_;
}

double CloudScales::extent() {
  const std::scoped_lock lock(mutex_);
  return known_extent();
}

double CloudScales::voxel_size() {
  const std::scoped_lock lock(mutex_);
  if (!voxel_size_) {
    const double extent = known_extent();
    voxel_size_ = extent > 0 ? kVoxelShare * extent : 1;
  }
  return *voxel_size_;
}

CloudScales::Scale* CloudScales::find(double voxel_size, double normal_radius,
                                      double feature_radius) {
  const auto known = std::find_if(scales_.begin(), scales_.end(), [&](const Scale& scale) {
    return scale.surface.voxel_size == voxel_size && scale.normal_radius == normal_radius &&
           scale.feature_radius == feature_radius;
  });
  return known == scales_.end() ? nullptr : &*known;
}

const Surface& CloudScales::surface(double voxel_size, const FrontendOptions& frontend,
                                    int num_threads, StageClock& clock) {
  const std::scoped_lock lock(mutex_);
  if (const Scale* known = find(voxel_size, frontend.normal_radius, frontend.feature_radius)) {
    return known->surface;
  }
  scales_.push_back({frontend.normal_radius,
                     frontend.feature_radius,
                     make_surface(points_, voxel_size, frontend, num_threads, clock),
                     {}});
  return scales_.back().surface;
}

const Features& CloudScales::features(const Surface& surface, NormalOrientation side,
                                      const Eigen::Vector3d& viewpoint, int num_threads,
                                      StageClock& clock) {
  const std::scoped_lock lock(mutex_);
  auto& scale = *std::find_if(scales_.begin(), scales_.end(),
                              [&](const Scale& one) { return &one.surface == &surface; });
  const auto known =
      std::find_if(scale.described.begin(), scale.described.end(), [&](const Described& one) {
        return one.side == side &&
               (side == NormalOrientation::Outward || one.viewpoint == viewpoint);
      });
  if (known != scale.described.end()) return known->features;
  if (!scale.surface.neighbourhoods) {  // of a file, which does not hold them
    scale.surface.neighbourhoods =
        find_neighbourhoods(scale.surface.local, scale.feature_radius, num_threads);
  }
  scale.described.push_back(
      {side, viewpoint, describe(scale.surface, side, viewpoint, num_threads, clock)});
  return scale.described.back().features;
}

std::vector<KnownSurface> CloudScales::known() const {
  const std::scoped_lock lock(mutex_);
  std::vector<KnownSurface> all;
  for (const Scale& scale : scales_) {
    for (const Described& described : scale.described) {
      all.push_back({scale.surface.voxel_size, scale.normal_radius, scale.feature_radius,
                     described.side, described.viewpoint, scale.surface.voxels,
                     scale.surface.normals, described.features});
    }
  }
  return all;
}

void CloudScales::add(KnownSurface known) {
  const std::scoped_lock lock(mutex_);
  Scale* scale = find(known.voxel_size, known.normal_radius, known.feature_radius);
  if (scale == nullptr) {
    scales_.push_back({known.normal_radius,
                       known.feature_radius,
                       known_surface(points_, known.voxel_size, std::move(known.voxels),
                                     std::move(known.normals)),
                       {}});
    scale = &scales_.back();
  }
  scale->described.push_back({known.side, known.viewpoint, std::move(known.features)});
}

}  // namespace gmcr::frontend
