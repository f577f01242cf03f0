// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/features/nearest_features_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/features/nearest_features.hpp"

#ifndef GMCR_KERNELS_NEAREST_FEATURES_SIMD_POINTERS  // once for all instruction sets
#define GMCR_KERNELS_NEAREST_FEATURES_SIMD_POINTERS
namespace gmcr::kernels {

constexpr int kMostLanes = 16;  // those of a group

/// What a pass reads and writes as plain data: code of one instruction set instantiates no template
/// that code of another could be linked to.
struct FeaturePass {
  const std::int32_t* queries[kFeatureQueries];  ///< -2 times the two bins of each pair
  std::int32_t squared_norms[kFeatureQueries];   ///< of the queries
  Index num_pairs, num_groups;
  const std::int16_t* targets;
  const std::int32_t* target_norms;
  std::int32_t *least, *least_index;  ///< of the targets
  std::int32_t first;                 ///< number of the first query
  // of each lane: nearest, second nearest, and index of the nearest
  std::int32_t nearest[kFeatureQueries][kMostLanes], second[kFeatureQueries][kMostLanes],
      index[kFeatureQueries][kMostLanes];
  Index num_lanes;
};

}  // namespace gmcr::kernels
#endif

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<std::int32_t, kMostLanes>;
using Vector = hn::Vec<Lanes>;

#if HWY_TARGET == HWY_SCALAR  // has no vectors of two halves
struct Bins {
  std::int16_t first, second;
};

HWY_INLINE Bins load_bins(const std::int16_t* values) { return {values[0], values[1]}; }

/// Sum of products of pairs of bins, for each lane.
struct Products {
  std::int32_t sum = 0;

  HWY_INLINE void add(std::int32_t query, Bins bins) {
    const auto first = static_cast<std::int16_t>(query & 0xffff);
    const auto second = static_cast<std::int16_t>(query >> 16);
    sum += first * bins.first + second * bins.second;
  }
  HWY_INLINE Vector total() const { return hn::Set(Lanes(), sum); }
};
#else
using Halves = hn::Repartition<std::int16_t, Lanes>;
using Bins = hn::Vec<Halves>;

HWY_INLINE Bins load_bins(const std::int16_t* values) { return hn::LoadU(Halves(), values); }

/// Sum of products of pairs of bins, for each lane.
struct Products {
  Vector even, odd;

  HWY_INLINE Products() : even(hn::Zero(Lanes())), odd(hn::Zero(Lanes())) {}

  HWY_INLINE void add(std::int32_t query, Bins bins) {
    const Lanes lanes;
    even = hn::ReorderWidenMulAccumulate(lanes, hn::BitCast(Halves(), hn::Set(lanes, query)), bins,
                                         even, odd);
  }
  HWY_INLINE Vector total() const { return hn::RearrangeToOddPlusEven(even, odd); }
};
#endif

/// The nearest targets of a query among those of each lane.
struct LaneBest {
  Vector nearest, second, index;

  HWY_INLINE LaneBest()
      : nearest(hn::Set(Lanes(), NearestFeature::kNone)),
        second(nearest),
        index(hn::Set(Lanes(), -1)) {}

  HWY_INLINE void offer(Vector distance, Vector target) {
    second = hn::Min(second, hn::Max(nearest, distance));
    index = hn::IfThenElse(hn::Lt(distance, nearest), target, index);
    nearest = hn::Min(nearest, distance);
  }
};

}  // namespace

void compare_features(FeaturePass& pass) {
  const Lanes lanes;
  const auto num_lanes = static_cast<Index>(hn::Lanes(lanes));
  LaneBest best[kFeatureQueries];
  for (Index g = 0; g < pass.num_groups; ++g) {
    const std::int16_t* group = pass.targets + 2 * kMostLanes * pass.num_pairs * g;
    for (Index lane = 0; lane < kMostLanes; lane += num_lanes) {
      const Index j = kMostLanes * g + lane;
      Products products[kFeatureQueries];
      for (Index p = 0; p < pass.num_pairs; ++p) {
        const Bins bins = load_bins(group + 2 * (kMostLanes * p + lane));
        for (Index q = 0; q < kFeatureQueries; ++q) products[q].add(pass.queries[q][p], bins);
      }
      const Vector norms = hn::LoadU(lanes, pass.target_norms + j);
      const Vector target = hn::Iota(lanes, static_cast<std::int32_t>(j));
      Vector least = hn::LoadU(lanes, pass.least + j);
      Vector least_index = hn::LoadU(lanes, pass.least_index + j);
      for (Index q = 0; q < kFeatureQueries; ++q) {
        const Vector distance =
            hn::Add(hn::Add(norms, hn::Set(lanes, pass.squared_norms[q])), products[q].total());
        best[q].offer(distance, target);
        const Vector source = hn::Set(lanes, pass.first + static_cast<std::int32_t>(q));
        least_index = hn::IfThenElse(hn::Lt(distance, least), source, least_index);
        least = hn::Min(least, distance);
      }
      hn::StoreU(least, lanes, pass.least + j);
      hn::StoreU(least_index, lanes, pass.least_index + j);
    }
  }
  pass.num_lanes = num_lanes;
  for (Index q = 0; q < kFeatureQueries; ++q) {
    hn::StoreU(best[q].nearest, lanes, pass.nearest[q]);
    hn::StoreU(best[q].second, lanes, pass.second[q]);
    hn::StoreU(best[q].index, lanes, pass.index[q]);
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <bit>

namespace gmcr::kernels {

HWY_EXPORT(compare_features);

namespace {

/// Two 16-bit numbers as one of 32 bits, as they lie in memory.
std::int32_t packed(std::int32_t first, std::int32_t second) {
  const std::int16_t both[] = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(second)};
  return std::bit_cast<std::int32_t>(both);
}

/// The best of all lanes; of those that tie the one of smallest index.
NearestFeature best_lane(const FeaturePass& pass, Index q) {
  NearestFeature best;
  for (Index lane = 0; lane < pass.num_lanes; ++lane) {
    const std::int32_t distance = pass.nearest[q][lane], index = pass.index[q][lane];
    const bool is_nearer = distance < best.squared_distance ||
                           (distance == best.squared_distance && index < best.index);
    best.second =
        std::min({best.second, pass.second[q][lane], std::max(distance, best.squared_distance)});
    if (!is_nearer) continue;
    best.squared_distance = distance;
    best.index = index;
  }
  return best;
}

}  // namespace

void nearest_features(const IntegerFeatures& sources, Index first, Index count,
                      const IntegerFeatures& targets, NearestFeature* nearest,
                      NearestSources& sources_of_targets) {
  const Index num_pairs = targets.num_pairs();
  std::vector<std::int32_t> queries(static_cast<std::size_t>(kFeatureQueries * num_pairs));
  FeaturePass pass{};
  for (Index q = 0; q < kFeatureQueries; ++q) {
    // what is missing repeats the last one, which is not nearer than itself
    const Index i = first + std::min(q, count - 1);
    std::int32_t* row = queries.data() + num_pairs * q;
    for (Index p = 0; p < num_pairs; ++p) {
      row[p] = packed(-2 * sources.value(i, p, 0), -2 * sources.value(i, p, 1));
    }
    pass.queries[q] = row;
    pass.squared_norms[q] = sources.squared_norms()[i];
  }
  pass.num_pairs = num_pairs;
  pass.num_groups = targets.num_groups();
  pass.targets = targets.group(0);
  pass.target_norms = targets.squared_norms();
  pass.least = sources_of_targets.squared_distances.data();
  pass.least_index = sources_of_targets.indices.data();
  pass.first = static_cast<std::int32_t>(first);
  HWY_DYNAMIC_DISPATCH(compare_features)(pass);
  for (Index q = 0; q < count; ++q) nearest[q] = best_lane(pass, q);
}

}  // namespace gmcr::kernels
#endif
