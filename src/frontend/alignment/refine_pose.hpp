#pragma once

#include "frontend/alignment/centred_pair.hpp"
#include "frontend/alignment/plane_pairs.hpp"
#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// The pose that a refinement led to.
struct RefinedPose {
  Similarity target_from_source;
  bool is_applied = false;  ///< the surfaces meet more closely there than at the start
  double noise = 0;         ///< standard deviation of what meets, along the normals, metres
  PlanePairs pairs;         ///< what meets at it
  double radius = 0;        ///< metres: of the search for them
  double kernel = 0;        ///< metres: of their cost
};

/// How coarse the clouds are, and where the alignment starts.
struct RefinementScale {
  double cell = 0;   ///< metres, target frame: spacing of the points
  double reach = 0;  ///< cells: how far the start may be off
  Index max_samples = 0;
  double least_step = 0;  ///< cells: a shorter step ends it
};

/// Refines a pose of two clouds from wide to narrow (`align`), and keeps the start where the
/// surfaces do not meet more closely at the end of it: by the robust cost of the same samples, with
/// the same kernel, which follows the noise found.
///
/// @param pair  clouds after a voxel grid; keeps the normals that are needed.
/// @param options  `scale_mode`, `scale_range`, `num_threads` and the priors are read.
/// Cost O(N log N) and O(log N) for each sample and step. Deterministic for any thread count, but
/// for the deadline.
RefinedPose refine_pose(CentredPair& pair, const Similarity& start, const RefinementScale& scale,
                        const Options& options, const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
