#pragma once

#include <optional>

#include "frontend/alignment/centred_pair.hpp"
#include "frontend/alignment/refine_pose.hpp"
#include "gmcr/result.hpp"

namespace gmcr::frontend {

/// How sure the surfaces that meet make the pose at which they meet best.
///
/// The refinement minimises a sum of costs, so its covariance is that of an M-estimate (Huber
/// 1967): with H the second derivative of the sum and G the covariance of its first, H^-1 G H^-1.
/// H is measured by small motions to either side, after which points find their neighbours anew:
/// where the noise is as large as the spacing, they hold a pose less than the same pairs would.
/// Errors of points near each other are alike, by the sensor, its calibration and the voxels: G is
/// the scatter of the sums over up to 64 blocks of as many pairs each (Liang and Zeger 1986). Along
/// motions that the surfaces leave open (kWeakStiffness) the covariance is that of the matches.
/// @param refined     with the pairs at its pose.
/// @param of_matches  at the same pose.
/// @return `of_matches` where few pairs meet or they hold no motion; nullopt where neither says
///   all.
/// Cost O(pairs * log pairs), and twelve or fourteen times that of finding 2,000 pairs.
/// Deterministic for any thread count.
std::optional<Covariance> surface_covariance(CentredPair& clouds, const RefinedPose& refined,
                                             bool estimates_scale,
                                             const std::optional<Covariance>& of_matches,
                                             int num_threads);

}  // namespace gmcr::frontend
