#pragma once

#include "frontend/alignment/surface_cloud.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr::frontend {

/// How well two clouds cover each other.
struct Overlap {
  double fitness = 0;  ///< share of the source points with a target point nearer than the radius
  double rmse = 0;     ///< root mean square distance of those, metres
};

/// Overlap of the transformed source with the target.
///
/// @param target_from_source  between the centred frames.
/// @param radius  metres, target frame, > 0.
/// Cost O(N). Deterministic for any thread count.
Overlap measure_overlap(const SurfaceCloud& source, SurfaceCloud& target,
                        const Similarity& target_from_source, double radius, int num_threads);

}  // namespace gmcr::frontend
