#pragma once

#include <optional>
#include <vector>

#include "gmcr/options.hpp"
#include "paper/tims.hpp"

namespace gmcr::paper {

/// What the scale stage finds.
struct ScaleConsensus {
  double scale = 1;
  std::vector<Index> tims;  ///< TIMs of the clique, ascending
};

/// Scale stage: the maximum clique of the scale consensus graph, Eq. (11), by the interval sweep
/// (L2), and the best scale for it, Eq. (10) without outliers.
/// @param scales  where the scale must lie.
/// @return nullopt where no TIM measures a scale in the range. Cost O(K log K) for K TIMs.
std::optional<ScaleConsensus> scale_consensus(const Tims& tims, const ScaleRange& scales);

}  // namespace gmcr::paper
