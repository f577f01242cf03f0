#include <cmath>
#include <stdexcept>
#include <string>

#include "gmcr/frontend.hpp"

namespace gmcr {
namespace {

void require(bool holds, const char* field, double value, const char* rule) {
  if (holds) return;
  throw std::invalid_argument(std::string(field) + ": " + std::to_string(value) + " " + rule);
}

void require_positive(double value, const char* field) {
  require(value > 0 && std::isfinite(value), field, value, "is not positive and finite");
}

void require_not_negative(double value, const char* field) {
  require(value >= 0 && std::isfinite(value), field, value, "is negative or not finite");
}

}  // namespace

void FrontendOptions::validate() const {
  require_not_negative(voxel_size, "voxel_size");
  require_not_negative(source_voxel_size, "source_voxel_size");
  require_positive(normal_radius, "normal_radius");
  require_positive(feature_radius, "feature_radius");
  require(feature_radius >= normal_radius, "feature_radius", feature_radius,
          "is below normal_radius");
  require_positive(noise_bound_voxels, "noise_bound_voxels");
  require(source_viewpoint.allFinite(), "source_viewpoint", source_viewpoint.sum(),
          "is not finite");
  require(target_viewpoint.allFinite(), "target_viewpoint", target_viewpoint.sum(),
          "is not finite");
  require(max_ratio > 0 && max_ratio <= 1, "max_ratio", max_ratio, "is not in (0, 1]");
  require(max_attempts >= 1, "max_attempts", max_attempts, "is below 1");
}

}  // namespace gmcr
