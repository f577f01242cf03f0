#pragma once

#include "frontend/alignment/centred_pair.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Stiffness below which a motion is not held. Bare ground leaves two of 0.002 to 0.007, since its
/// normals are noisy; an object whose turn still is held has 0.01.
inline constexpr double kWeakStiffness = 0.008;

/// How the surfaces meet under a pose, from at most so many points of each.
/// @param target_from_source  of the caller's frames.
/// @param radius  metres, target frame: what is nearer than that meets.
/// Cost O(log N) for each sample. Deterministic for any thread count.
SurfaceFit measure_surfaces(CentredPair& pair, const Similarity& target_from_source, double radius,
                            Index max_samples, int num_threads);

}  // namespace gmcr::frontend
