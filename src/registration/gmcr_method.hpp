#pragma once

#include <optional>

#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// What a method found, between the centred frames, and proved.
struct MethodResult {
  std::optional<Similarity> target_from_source;
  Index upper_bound = 0;  ///< proven: no pose has more inliers
};

/// `Method::Gmcr`: candidate cliques judged by the objective, bounds from clique numbers.
/// @param scales  where the scale must lie; min == max: it is known.
MethodResult solve_gmcr(SolveContext& context, const Objective& objective,
                        const ScaleRange& scales);

}  // namespace gmcr
