#include <algorithm>

#include "frontend/cloud_pair.hpp"

namespace gmcr::frontend {

std::vector<FrontendSetting> list_settings(const FrontendOptions& frontend) {
  using enum NormalOrientation;
  // Range images and scans in the sensor's frame first: of 40 real pairs this settles 31. Then a
  // model of a whole object sought in such a scan, and coarser voxels for noise: one more each. The
  // unfiltered ones bring some noisy small objects close.
  const std::vector<FrontendSetting> all = {
      {1, TowardViewpoint, TowardViewpoint},    {1, Outward, TowardViewpoint},
      {1.5, TowardViewpoint, TowardViewpoint},  {1, Outward, Outward},
      {1.5, Outward, TowardViewpoint, true, 1}, {1.5, Outward, TowardViewpoint, true, 1.6},
      {1, Outward, TowardViewpoint, true, 1.6}, {1.5, Outward, Outward}};
  std::vector<FrontendSetting> settings;
  for (FrontendSetting setting : all) {
    if (frontend.orientation != Automatic && (setting.source_side != frontend.orientation ||
                                              setting.target_side != frontend.orientation)) {
      continue;
    }
    const bool asked_for_voxels = frontend.voxel_size > 0 && setting.voxel_factor != 1;
    if (asked_for_voxels) continue;
    settings.push_back(setting);
  }
  const auto count = std::min(settings.size(), static_cast<std::size_t>(frontend.max_attempts));
  settings.resize(count);
  return settings;
}

}  // namespace gmcr::frontend
