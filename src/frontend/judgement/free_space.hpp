#pragma once

#include "frontend/alignment/centred_pair.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr::frontend {

/// The share of a cloud that lies where the sensor of the other one saw through, of that and what
/// the other one covers; the larger one of the two clouds. At right poses of real scans 0.005 and
/// less, where their viewpoints are known; rooms that are turned by half have 0.02 to 0.3.
///
/// @param target_from_source  of the caller's frames.
/// @param voxel        metres, target frame: what lies two of them off is not covered, and a ray
///   sees through what it passes by three.
/// @param max_samples  of each cloud.
/// @return 0 where no sensor's place is known.
/// Cost O(samples). Deterministic for any thread count.
double measure_contradiction(CentredPair& pair, const Similarity& target_from_source, double voxel,
                             Index max_samples, int num_threads);

}  // namespace gmcr::frontend
