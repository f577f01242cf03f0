#pragma once

#include <optional>

#include "gmcr/priors.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::bench {

/// Correspondences with their truth.
struct Problem {
  Points source;
  Points target;
  Similarity truth;
  double noise_bound = 0;
  std::optional<GravityPrior> gravity = std::nullopt;  ///< where it is known
};

}  // namespace gmcr::bench
