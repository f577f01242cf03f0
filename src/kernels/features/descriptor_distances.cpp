#include "kernels/features/descriptor_distances.hpp"

#include <bit>

namespace gmcr::kernels {
namespace {

/// Sums term(value, query value) over the values of each target.
template <class Value, class Sum, class Term>
void sum_terms(const GroupedDescriptors<Value>& targets, const Value* query, float* distances,
               Sum zero, const Term& term) {
  constexpr Index kGroup = GroupedDescriptors<Value>::kGroup;
  for (Index i = 0; i < kGroup * targets.num_groups(); ++i) {
    const Value* first =
        targets.values() + kGroup * targets.num_values() * (i / kGroup) + i % kGroup;
    Sum sum = zero;
    for (Index d = 0; d < targets.num_values(); ++d) sum += term(first[kGroup * d], query[d]);
    distances[i] = static_cast<float>(sum);
  }
}

}  // namespace

void squared_distances_reference(const GroupedDescriptors<float>& targets, const float* query,
                                 float* distances) {
  sum_terms(targets, query, distances, 0.0f, [](float a, float b) { return (a - b) * (a - b); });
}

void hamming_distances_reference(const GroupedDescriptors<std::uint64_t>& targets,
                                 const std::uint64_t* query, float* distances) {
  sum_terms(targets, query, distances, std::int64_t{0},
            [](std::uint64_t a, std::uint64_t b) { return std::popcount(a ^ b); });
}

}  // namespace gmcr::kernels
