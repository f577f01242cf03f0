#include "kernels/features/nearest_features.hpp"

#include <cmath>

namespace gmcr::kernels {

IntegerFeatures::IntegerFeatures(const float* values, Index num_bins, Index count,
                                 double resolution)
    : count_(count), num_pairs_((num_bins + 1) / 2) {
  const Index num_groups = (count + kGroup - 1) / kGroup;
  values_.resize(static_cast<std::size_t>(2 * kGroup * num_pairs_ * num_groups));
  squared_norms_.assign(static_cast<std::size_t>(kGroup * num_groups), kFarAway);
  for (Index i = 0; i < count; ++i) {
    std::int16_t* group = values_.data() + 2 * kGroup * num_pairs_ * (i / kGroup);
    std::int32_t squared_norm = 0;
    for (Index bin = 0; bin < num_bins; ++bin) {
      // to the nearest whole number: of a single precision value the sum is exact
      const double scaled = resolution * static_cast<double>(values[num_bins * i + bin]);
      const auto value = static_cast<std::int32_t>(scaled + std::copysign(0.5, scaled));
      group[2 * (kGroup * (bin / 2) + i % kGroup) + bin % 2] = static_cast<std::int16_t>(value);
      squared_norm += value * value;
    }
    squared_norms_[static_cast<std::size_t>(i)] = squared_norm;
  }
}

double IntegerFeatures::resolution_for(double largest_squared_norm) {
  constexpr double kMost = 1 << 28;
  double resolution = kFinest;
  while (largest_squared_norm * resolution * resolution > kMost) resolution /= 2;
  return resolution;
}

void nearest_features_reference(const IntegerFeatures& sources, Index first, Index count,
                                const IntegerFeatures& targets, NearestFeature* nearest,
                                NearestSources& sources_of_targets) {
  for (Index q = 0; q < count; ++q) {
    nearest[q] = {};
    for (Index j = 0; j < IntegerFeatures::kGroup * targets.num_groups(); ++j) {
      std::int32_t distance = sources.squared_norms()[first + q] + targets.squared_norms()[j];
      for (Index p = 0; p < targets.num_pairs(); ++p) {
        for (Index b = 0; b < 2; ++b) {
          distance -= 2 * sources.value(first + q, p, b) * targets.value(j, p, b);
        }
      }
      nearest[q].offer(distance, static_cast<std::int32_t>(j));
      auto& least = sources_of_targets.squared_distances[static_cast<std::size_t>(j)];
      if (distance >= least) continue;
      least = distance;
      sources_of_targets.indices[static_cast<std::size_t>(j)] =
          static_cast<std::int32_t>(first + q);
    }
  }
}

}  // namespace gmcr::kernels
