#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Descriptors as whole numbers, so that distances are exact and do not depend on the order of the
/// sums.
///
/// Two bins of a descriptor stand side by side, and so do those of the descriptors of a group:
/// value 2 (kGroup p + lane) + b of a group is bin 2 p + b of descriptor `lane`. The last group is
/// filled up with descriptors that are never nearest.
class IntegerFeatures {
 public:
  static constexpr Index kGroup = 16;
  static constexpr std::int32_t kFarAway = 3 << 29;  ///< squared norm of what fills a group

  /// @param values      a column a descriptor, `num_bins` x `count`, finite.
  /// @param resolution  what a value is multiplied by before it is rounded. Squared norms times its
  ///   square are at most 2^28.
  IntegerFeatures(const float* values, Index num_bins, Index count, double resolution);

  /// The largest power of two up to `kFinest` that keeps squared norms within what is exact.
  static double resolution_for(double largest_squared_norm);
  static constexpr double kFinest = 64;

  Index size() const { return count_; }
  Index num_pairs() const { return num_pairs_; }  ///< of bins
  Index num_groups() const { return static_cast<Index>(squared_norms_.size()) / kGroup; }
  const std::int16_t* group(Index g) const { return values_.data() + 2 * kGroup * num_pairs_ * g; }
  const std::int32_t* squared_norms() const { return squared_norms_.data(); }

  /// Bin 2 p + b of descriptor i.
  std::int16_t value(Index i, Index p, Index b) const {
    return group(i / kGroup)[2 * (kGroup * p + i % kGroup) + b];
  }

 private:
  Index count_, num_pairs_;
  std::vector<std::int16_t> values_;
  std::vector<std::int32_t> squared_norms_;
};

/// Nearest and second nearest of many, by squared distance in units of 1 / resolution^2.
struct NearestFeature {
  static constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();

  std::int32_t squared_distance = kNone;
  std::int32_t second = kNone;
  std::int32_t index = -1;  ///< the smallest of those that tie

  /// Candidates come in ascending order of index.
  void offer(std::int32_t candidate, std::int32_t candidate_index) {
    if (candidate < squared_distance) {
      second = squared_distance;
      squared_distance = candidate;
      index = candidate_index;
    } else if (candidate < second) {
      second = candidate;
    }
  }
};

/// For each target, in the order of the groups, the nearest source so far.
struct NearestSources {
  explicit NearestSources(const IntegerFeatures& targets)
      : squared_distances(static_cast<std::size_t>(IntegerFeatures::kGroup * targets.num_groups()),
                          NearestFeature::kNone),
        indices(squared_distances.size(), -1) {}

  std::vector<std::int32_t> squared_distances, indices;
};

constexpr Index kFeatureQueries = 4;  ///< sources that share the loads of a pass over the targets

/// Compares `count` <= kFeatureQueries sources from number `first` on with all targets.
/// @param nearest   `count` values.
/// @param sources_of_targets  updated; sources come in ascending order.
/// The same values on every instruction set. Cost O(number of targets): 17 multiply-adds of a
/// vector of lanes a pair of descriptors of 33 bins.
void nearest_features(const IntegerFeatures& sources, Index first, Index count,
                      const IntegerFeatures& targets, NearestFeature* nearest,
                      NearestSources& sources_of_targets);

/// The same, one pair after the other: the specification.
void nearest_features_reference(const IntegerFeatures& sources, Index first, Index count,
                                const IntegerFeatures& targets, NearestFeature* nearest,
                                NearestSources& sources_of_targets);

}  // namespace gmcr::kernels
