#pragma once

#include <optional>

#include "consensus/pair_filter.hpp"
#include "estimation/pose_constraints.hpp"
#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// What a method found, between the centred frames, and proved.
struct MethodResult {
  std::optional<Similarity> target_from_source;
  /// Proven: no admitted pose has more inliers; with one-to-one, of which no two share a point.
  Index upper_bound = 0;
};

/// `Method::Gmcr`: candidate cliques judged by the objective, bounds from clique numbers.
/// @param filter  what the priors and one-to-one say of pairs.
MethodResult solve_gmcr(SolveContext& context, const Objective& objective,
                        const PoseConstraints& constraints, const PairFilter& filter);

}  // namespace gmcr
