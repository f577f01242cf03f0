#pragma once

#include <cstdint>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Descriptors side by side: value d of descriptor i is at
/// kGroup (num_values (i / kGroup) + d) + i % kGroup. The last group is filled up with 0.
template <class Value>
class GroupedDescriptors {
 public:
  static constexpr Index kGroup = 32;

  /// @param value_of  value_of(d, i), called once for each.
  template <class ValueOf>
  GroupedDescriptors(Index num_values, Index count, const ValueOf& value_of)
      : num_values_(num_values), count_(count) {
    values_.resize(static_cast<std::size_t>(kGroup * num_values * num_groups()));
    for (Index i = 0; i < count; ++i) {
      Value* first = values_.data() + kGroup * num_values * (i / kGroup) + i % kGroup;
      for (Index d = 0; d < num_values; ++d) first[kGroup * d] = value_of(d, i);
    }
  }

  Index size() const { return count_; }
  Index num_values() const { return num_values_; }
  Index num_groups() const { return (count_ + kGroup - 1) / kGroup; }
  const Value* values() const { return values_.data(); }

 private:
  Index num_values_, count_;
  std::vector<Value> values_;
};

/// Squared Euclidean distances of a descriptor from all targets, each summed value after value.
/// @param query      `num_values` values.
/// @param distances  kGroup * num_groups values; those past `size` mean nothing.
/// The same bits as the reference on every instruction set. Cost O(M D).
void squared_distances(const GroupedDescriptors<float>& targets, const float* query,
                       float* distances);
void squared_distances_reference(const GroupedDescriptors<float>& targets, const float* query,
                                 float* distances);

/// The same for bits, 64 a value: how many differ.
void hamming_distances(const GroupedDescriptors<std::uint64_t>& targets, const std::uint64_t* query,
                       float* distances);
void hamming_distances_reference(const GroupedDescriptors<std::uint64_t>& targets,
                                 const std::uint64_t* query, float* distances);

}  // namespace gmcr::kernels
