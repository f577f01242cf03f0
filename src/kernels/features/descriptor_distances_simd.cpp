// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/features/descriptor_distances_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/features/descriptor_distances.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr Index kLanesOfGroup = 32;

/// Adds up term(values of targets, value of the query) for the descriptors of a group.
template <class Lanes, class Value, class Term>
HWY_INLINE void sum_terms(Lanes lanes, const Value* group, Index num_values, const Value* query,
                          const Term& term, Value* sums) {
  constexpr auto kNumLanes = static_cast<Index>(hn::MaxLanes(Lanes()));
  constexpr Index kVectors = kLanesOfGroup / kNumLanes;
  hn::Vec<Lanes> sum[kVectors];
  for (Index v = 0; v < kVectors; ++v) sum[v] = hn::Zero(lanes);
  for (Index d = 0; d < num_values; ++d) {
    const auto value = hn::Set(lanes, query[d]);
    for (Index v = 0; v < kVectors; ++v) {
      const auto values = hn::LoadU(lanes, group + kLanesOfGroup * d + kNumLanes * v);
      sum[v] = hn::Add(sum[v], term(values, value));
    }
  }
  for (Index v = 0; v < kVectors; ++v) hn::StoreU(sum[v], lanes, sums + kNumLanes * v);
}

using Floats = hn::CappedTag<float, kLanesOfGroup>;
using Words = hn::CappedTag<std::uint64_t, kLanesOfGroup>;

/// No fused multiply-add: the bits of the reference.
struct SquaredDifference {
  HWY_INLINE hn::Vec<Floats> operator()(hn::Vec<Floats> a, hn::Vec<Floats> b) const {
    const auto difference = hn::Sub(a, b);
    return hn::Mul(difference, difference);
  }
};

struct DifferentBits {
  HWY_INLINE hn::Vec<Words> operator()(hn::Vec<Words> a, hn::Vec<Words> b) const {
    return hn::PopulationCount(hn::Xor(a, b));
  }
};

}  // namespace

void squared(const float* targets, Index num_values, Index num_groups, const float* query,
             float* distances) {
  for (Index g = 0; g < num_groups; ++g) {
    sum_terms(Floats(), targets + kLanesOfGroup * num_values * g, num_values, query,
              SquaredDifference(), distances + kLanesOfGroup * g);
  }
}

void hamming(const std::uint64_t* targets, Index num_values, Index num_groups,
             const std::uint64_t* query, float* distances) {
  for (Index g = 0; g < num_groups; ++g) {
    std::uint64_t counts[kLanesOfGroup];
    sum_terms(Words(), targets + kLanesOfGroup * num_values * g, num_values, query, DifferentBits(),
              counts);
    for (Index lane = 0; lane < kLanesOfGroup; ++lane) {
      distances[kLanesOfGroup * g + lane] = static_cast<float>(counts[lane]);
    }
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(squared);
HWY_EXPORT(hamming);

void squared_distances(const GroupedDescriptors<float>& targets, const float* query,
                       float* distances) {
  HWY_DYNAMIC_DISPATCH(squared)
  (targets.values(), targets.num_values(), targets.num_groups(), query, distances);
}

void hamming_distances(const GroupedDescriptors<std::uint64_t>& targets, const std::uint64_t* query,
                       float* distances) {
  HWY_DYNAMIC_DISPATCH(hamming)
  (targets.values(), targets.num_values(), targets.num_groups(), query, distances);
}

}  // namespace gmcr::kernels
#endif
