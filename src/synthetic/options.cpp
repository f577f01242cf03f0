#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "gmcr/synthetic.hpp"
#include "synthetic/draft.hpp"

namespace gmcr {
namespace {

template <typename Value>
void require(bool holds, const char* field, Value value, const char* rule) {
  if (holds) return;
  std::ostringstream message;
  message << value << ", must be " << rule;
  throw InvalidOption(field, message.str());
}

double largest_noise(const SyntheticOptions& options) {
  const double diagonal = options.noise_shape == NoiseShape::Cube ? std::sqrt(3.0) : 1.0;
  return diagonal * options.noise_extent;
}

void validate_structured(const SyntheticOptions& options) {
  require(options.num_bases >= 0, "num_bases", options.num_bases, ">= 0");
  require(options.source_neighbors >= 0, "source_neighbors", options.source_neighbors, ">= 0");
  require(options.target_neighbors >= options.source_neighbors, "target_neighbors",
          options.target_neighbors, ">= source_neighbors");
  require(options.association_neighbors >= 0, "association_neighbors",
          options.association_neighbors, ">= 0");
  require(options.target_neighbors < options.num_cloud_points, "target_neighbors",
          options.target_neighbors, "< num_cloud_points");
  const Index capacity = options.num_bases * (options.source_neighbors + 1);
  require(options.num_bases == 0 || capacity >= synthetic::num_outliers(options), "num_bases",
          options.num_bases, "enough for all outliers, source_neighbors + 1 a base");
}

}  // namespace

void SyntheticOptions::validate() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  require(num_correspondences >= 0, "num_correspondences", num_correspondences, ">= 0");
  require(outlier_rate >= 0 && outlier_rate <= 1, "outlier_rate", outlier_rate, "in [0, 1]");
  require(noise_extent >= 0 && noise_extent < kInfinity, "noise_extent", noise_extent,
          ">= 0 and finite");
  require(noise_bound > 0 && noise_bound < kInfinity, "noise_bound", noise_bound, "> 0 and finite");
  require(noise_bound >= largest_noise(*this), "noise_bound", noise_bound,
          "at least the largest norm of the noise");
  require(scale_range.min > 0, "scale_range.min", scale_range.min, "> 0");
  require(scale_range.max >= scale_range.min && scale_range.max < kInfinity, "scale_range.max",
          scale_range.max, ">= scale_range.min and finite");
  require(max_translation >= 0 && max_translation < kInfinity, "max_translation", max_translation,
          ">= 0 and finite");
  if (kind == SyntheticKind::Ball) return;
  require(num_cloud_points >= num_correspondences, "num_cloud_points", num_cloud_points,
          ">= num_correspondences");
  require(num_sphere_points >= 0, "num_sphere_points", num_sphere_points, ">= 0");
  if (kind == SyntheticKind::Structured) validate_structured(*this);
}

SyntheticOptions paper_random_options() {
  SyntheticOptions options;
  options.kind = SyntheticKind::Random;
  options.num_correspondences = 80;
  options.noise_shape = NoiseShape::Cube;
  options.noise_extent = 0.01;
  options.noise_bound = 0.02;
  options.scale_range = {1, 5};
  return options;
}

SyntheticOptions paper_structured_options() {
  SyntheticOptions options = paper_random_options();
  options.kind = SyntheticKind::Structured;
  options.num_correspondences = 90;
  options.noise_bound = 0.07;
  return options;
}

}  // namespace gmcr
