#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::clique {

/// Which sums of weights count as equal.
class WeightRounding {
 public:
  WeightRounding() = default;
  /// @param exact  sums of the weights do not round in double: only equal ones are equal.
  explicit WeightRounding(bool exact) : exact_(exact) {}

  /// The units of which a clique must have more to be heavier, beyond rounding, than `units`.
  std::int64_t to_beat(std::int64_t units) const {
    return exact_ ? units : units + units / kResolution;
  }

 private:
  // Sums that differ by less than this part of them count as equal.
  static constexpr std::int64_t kResolution = 1'000'000'000'000;

  bool exact_ = true;
};

/// Vertex weights as whole numbers of a unit, so that their sums are exact in any order.
///
/// The unit is a power of two for which all weights together are less than 2^62 units. Weights
/// round up, so a sum of units is never less than the sum of the weights.
class FixedPointWeights {
 public:
  /// @param weights  finite, >= 0.
  /// @throws std::invalid_argument naming the weight, or where their sum is not finite.
  explicit FixedPointWeights(std::span<const double> weights);

  std::span<const std::int64_t> units() const { return units_; }
  std::int64_t total() const { return total_; }

  WeightRounding rounding() const { return rounding_; }

  /// Units that `weight`, >= 0, holds in full; no more than 2^62.
  std::int64_t units_of(double weight) const;

  /// A weight that is no less than `units` units, and equal where that is a double.
  double weight_of(std::int64_t units) const;

 private:
  int exponent_ = 0;  // 2^exponent_ units are a weight of 1
  WeightRounding rounding_;
  std::int64_t total_ = 0;
  std::vector<std::int64_t> units_;
};

}  // namespace gmcr::clique
