#pragma once

#include <functional>

#include "frontend/alignment/plane_pairs.hpp"
#include "gmcr/similarity.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// What holds for every round of an alignment.
struct AlignmentRules {
  bool estimates_scale = false;
  std::function<bool(const Similarity&)> admits;  ///< poses between the centred frames
  const parallel::Deadline* deadline = nullptr;
  int num_threads = 0;
};

/// One stage of an alignment.
struct AlignmentRound {
  double radius = 0;  ///< metres, target frame: of the search for pairs
  int max_steps = 1;
  double least_step = 0;    ///< metres: a shorter step ends the round
  double least_kernel = 0;  ///< metres
};

/// The kernel is no wider than this share of the radius, and as wide as this many deviations of the
/// noise between.
inline constexpr double kKernelOfRadius = 0.5;
inline constexpr double kKernelOfNoise = 3;

/// Width of the kernel for these pairs, metres.
double kernel_of(const PlanePairs& pairs, const AlignmentRound& round);

/// The pose after a small motion, in the parameters of the equations.
Similarity moved_by(const MotionStep& step, const NormalEquations& equations,
                    const Similarity& pose);

/// The pose at which the plane patches of the two clouds meet best: generalised ICP (Segal, Haehnel
/// and Thrun, RSS 2009) with the kernel of Geman and McClure, whose width follows the noise found.
///
/// A step that leaves what is admitted is halved, and not taken where that does not help. Fewer
/// than 20 pairs, or an expired deadline, leave the pose as it is.
/// @param pose  between the centred frames; its scale stays unless it is estimated.
/// Cost O(steps * samples * log N). Deterministic for any thread count, but for the deadline.
Similarity align(SurfaceCloud& source, SurfaceCloud& target, const Samples& samples,
                 const AlignmentRound& round, const AlignmentRules& rules, Similarity pose);

}  // namespace gmcr::frontend
