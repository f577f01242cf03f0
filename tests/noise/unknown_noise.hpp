#pragma once

#include "gmcr/options.hpp"

namespace gmcr::testing {

inline Options unknown_noise(double scale = 1) {
  Options options;
  options.noise_mode = NoiseMode::Estimated;
  options.scale = scale;
  return options;
}

inline Options unknown_noise_and_scale() {
  Options options = unknown_noise();
  options.scale_mode = ScaleMode::Estimated;
  return options;
}

}  // namespace gmcr::testing
