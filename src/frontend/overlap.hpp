#pragma once

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// How well two clouds cover each other.
struct Overlap {
  double fitness = 0;  ///< share of the source points with a target point nearer than the radius
  double rmse = 0;     ///< root mean square distance of those, metres
};

/// Overlap of the transformed source with the target.
///
/// @param radius  metres, target frame, > 0.
/// @return zeros where a cloud is empty.
/// Cost O((N + M) log M). Deterministic for any thread count.
Overlap measure_overlap(const PointsRef& source, const PointsRef& target,
                        const Similarity& target_from_source, double radius, int num_threads);

}  // namespace gmcr::frontend
