#include <algorithm>

#include "frontend/cloud_pair.hpp"
#include "frontend/points/range_image.hpp"

namespace gmcr::frontend {
namespace {

/// Normal radius of further attempts over that of the first: sparse or noisy points leave few
/// neighbours to tell a normal by.
constexpr double kWiderNormals = 1.5;

}  // namespace

bool is_viewpoint_unknown(const PointsRef& points, const Eigen::Vector3d& viewpoint) {
  constexpr double kFarthest = 5;  // extents
  if (!viewpoint.isZero(0) || points.cols() == 0) return false;
  const Eigen::Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  return ((low + high) / 2).norm() > kFarthest * (high - low).norm() &&
         !RangeImage(points, viewpoint).is_view();
}

std::vector<FrontendSetting> list_settings(const FrontendOptions& frontend, const Clouds& clouds) {
  using enum NormalOrientation;
  // Range images and scans in the sensor's frame first: of 40 real pairs this settles 31. Then a
  // model of a whole object sought in such a scan, more matches of noisy scans on coarser voxels,
  // and models without a viewpoint.
  const std::vector<FrontendSetting> all = {
      {1, TowardViewpoint, TowardViewpoint},
      {1, Outward, TowardViewpoint, kWiderNormals},
      {1.5, TowardViewpoint, TowardViewpoint, kWiderNormals, true},
      {1, Outward, Outward, kWiderNormals},
      {1.5, Outward, Outward, kWiderNormals, true}};
  const bool is_automatic = frontend.orientation == Automatic;
  const bool no_source_view =
      is_automatic && is_viewpoint_unknown(clouds.source, frontend.source_viewpoint);
  const bool no_target_view =
      is_automatic && is_viewpoint_unknown(clouds.target, frontend.target_viewpoint);
  std::vector<FrontendSetting> settings;
  for (FrontendSetting setting : all) {
    if (no_source_view) setting.source_side = Outward;
    if (no_target_view) setting.target_side = Outward;
    if (frontend.orientation != Automatic && (setting.source_side != frontend.orientation ||
                                              setting.target_side != frontend.orientation)) {
      continue;
    }
    // of 40 real pairs none needs it where a viewpoint may be known
    if (is_automatic && setting.pools_radii && setting.source_side == Outward && !no_source_view) {
      continue;
    }
    const bool asked_for_voxels = frontend.voxel_size > 0 && setting.voxel_factor != 1;
    if (asked_for_voxels) continue;
    if (std::find(settings.begin(), settings.end(), setting) == settings.end()) {
      settings.push_back(setting);
    }
  }
  settings.front().normal_factor = 1;  // what a prepared cloud holds, whichever side was asked for
  const auto count = std::min(settings.size(), static_cast<std::size_t>(frontend.max_attempts));
  settings.resize(count);
  return settings;
}

}  // namespace gmcr::frontend
