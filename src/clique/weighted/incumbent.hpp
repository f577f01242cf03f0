#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "clique/weighted/fixed_point_weights.hpp"

namespace gmcr::clique {

/// The heaviest clique known so far and the weight that a clique must exceed to be of interest.
class WeightedIncumbent {
 public:
  /// @param weights  outlive this object.
  WeightedIncumbent(const FixedPointWeights& weights, double must_exceed)
      : weights_(weights), to_beat_(weights.rounding().to_beat(weights.units_of(must_exceed))) {}

  /// Keeps `clique` if it is heavier than the weight to beat.
  void offer(std::vector<Index> clique) {
    std::int64_t units = 0;
    for (const Index v : clique) units += weights_.units()[v];
    if (units <= to_beat_) return;
    clique_ = std::move(clique);
    to_beat_ = weights_.rounding().to_beat(units);
  }

  const FixedPointWeights& weights() const { return weights_; }
  const std::vector<Index>& clique() const { return clique_; }

  /// Units; cliques of no more count as no heavier than what is known.
  std::int64_t to_beat() const { return to_beat_; }

 private:
  const FixedPointWeights& weights_;
  std::vector<Index> clique_;
  std::int64_t to_beat_;
};

}  // namespace gmcr::clique
