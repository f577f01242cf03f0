#pragma once

#include "search/best_poses.hpp"

namespace gmcr::paper {

/// `Method::Paper`: the stages of the paper one after the other, one maximum clique each, on all of
/// the input; where memory or time binds, the diagnostics say so.
///
/// The stages know of the priors what single pairs say; their pose is then fitted anew among those
/// that the priors admit.
/// @param filter  what the priors and one-to-one say of pairs.
search::MethodResult solve_paper(problem::SolveContext& context,
                                 const problem::Correspondences& correspondences,
                                 const estimation::PoseConstraints& constraints,
                                 const problem::PairFilter& filter);

}  // namespace gmcr::paper
