#pragma once

#include "registration/gmcr_method.hpp"

namespace gmcr {

/// `Method::Paper`: the stages of the paper one after the other, one maximum clique each, on all of
/// the input; where memory or time binds, the diagnostics say so.
///
/// The stages know of the priors what single pairs say; their pose is then fitted anew among those
/// that the priors admit.
/// @param filter  what the priors and one-to-one say of pairs.
MethodResult solve_paper(SolveContext& context, const Correspondences& correspondences,
                         const PoseConstraints& constraints, const PairFilter& filter);

}  // namespace gmcr
