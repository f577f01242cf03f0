#include "frontend/cloud_scales.hpp"

#include <algorithm>
#include <utility>

#include "frontend/extent.hpp"

namespace gmcr::frontend {

double CloudScales::extent() {
  if (!extent_) extent_ = points_.cols() > 0 ? robust_extent(points_) : 0;
  return *extent_;
}

const Surface& CloudScales::surface(double voxel_size, const FrontendOptions& frontend,
                                    int num_threads, StageClock& clock) {
  const auto known = std::find_if(scales_.begin(), scales_.end(), [&](const Scale& scale) {
    return scale.surface.voxel_size == voxel_size &&
           scale.normal_radius == frontend.normal_radius &&
           scale.feature_radius == frontend.feature_radius;
  });
  if (known != scales_.end()) return known->surface;
  scales_.push_back({frontend.normal_radius,
                     frontend.feature_radius,
                     make_surface(points_, voxel_size, frontend, num_threads, clock),
                     {}});
  return scales_.back().surface;
}

const Features& CloudScales::features(const Surface& surface, NormalOrientation side,
                                      const Eigen::Vector3d& viewpoint, int num_threads,
                                      StageClock& clock) {
  auto& described = std::find_if(scales_.begin(), scales_.end(), [&](const Scale& scale) {
                      return &scale.surface == &surface;
                    })->described;
  const auto known = std::find_if(described.begin(), described.end(), [&](const Described& one) {
    return one.side == side && (side == NormalOrientation::Outward || one.viewpoint == viewpoint);
  });
  if (known != described.end()) return known->features;
  described.push_back({side, viewpoint, describe(surface, side, viewpoint, num_threads, clock)});
  return described.back().features;
}

}  // namespace gmcr::frontend
