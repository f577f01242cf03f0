#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frontend/judgement/surface_judge.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// The place of a scan, and what else was looked at.
struct PlacedScan {
  Candidate best;
  std::vector<RivalPose> rivals;  ///< other places at which the scan fits about as well, best first
  double runner_up = 0;           ///< overlap of the best other place over that of the best
};

/// Refines poses of a scan in a map, glances at all of them first, and compares them by their
/// surfaces.
/// @param pair    the voxels of the scan, and those of the whole map.
/// @param starts  at least one.
/// Poses that the options do not admit are left out.
/// @return nothing where no pose is admitted.
/// Cost O(starts). Deterministic for any thread count, but for the deadline.
std::optional<PlacedScan> compare_places(const std::shared_ptr<CentredPair>& pair, double voxel,
                                         const std::vector<Similarity>& starts,
                                         const Options& options,
                                         const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
