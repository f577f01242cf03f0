#include <algorithm>

#include "frontend/cloud_pair.hpp"

namespace gmcr {

std::vector<FrontendSetting> list_settings(const FrontendOptions& frontend) {
  using enum NormalOrientation;
  std::vector<FrontendSetting> settings;
  const bool automatic = frontend.orientation == Automatic;
  for (const double factor : {1.0, 0.7, 1.4}) {
    if (automatic || frontend.orientation == TowardViewpoint) {
      settings.push_back({factor, TowardViewpoint, TowardViewpoint});
    }
    if (automatic) settings.push_back({factor, Outward, TowardViewpoint});
    if (automatic || frontend.orientation == Outward)
      settings.push_back({factor, Outward, Outward});
  }
  const auto count = std::min(settings.size(), static_cast<std::size_t>(frontend.max_attempts));
  settings.resize(count);
  return settings;
}

}  // namespace gmcr
