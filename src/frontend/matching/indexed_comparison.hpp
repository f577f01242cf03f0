#pragma once

#include <cstdint>
#include <vector>

#include "frontend/features/fpfh.hpp"
#include "kernels/features/nearest_features.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// Nearest targets of the sources, and nearest sources of the targets.
struct NearestBothWays {
  std::vector<kernels::NearestFeature> of_source;  ///< index -1: not compared
  std::vector<std::int32_t> of_target;             ///< -1: none
};

/// The nearest of both among what lies in like places, of large clouds: features of the target are
/// put to the nearest of some places, means of them (k-means, Lloyd 1982), and each source is
/// compared with those of the 12 places nearest to it (an inverted file, Jegou, Douze and Schmid,
/// PAMI 2011).
///
/// The second nearest is that among what was compared.
/// @param source, target  a column a feature, N and M of them, at least one each.
/// @param resolution      of `kernels::IntegerFeatures`.
/// @param deadline        leaves the sources out that were not compared with all their places.
/// Cost O((N + M) sqrt(M)). Deterministic for any thread count, but for the deadline.
NearestBothWays nearest_in_places(const Features& source, const Features& target, double resolution,
                                  int num_threads, const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
