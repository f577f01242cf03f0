#pragma once

#include <random>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::test {

/// Weights of 1 / k, as clusters of k have them; most are 1.
inline std::vector<double> cluster_weights(Index num_vertices, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> weights;
  for (Index v = 0; v < num_vertices; ++v) {
    const auto k = generator() % 3 > 0 ? 1 : 1 + generator() % 12;
    weights.push_back(1.0 / static_cast<double>(k));
  }
  return weights;
}

/// Whole numbers of [1, max_weight].
inline std::vector<int> whole_weights(Index num_vertices, int max_weight, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<int> weights;
  for (Index v = 0; v < num_vertices; ++v) {
    weights.push_back(1 + static_cast<int>(generator() % static_cast<std::uint64_t>(max_weight)));
  }
  return weights;
}

}  // namespace gmcr::test
