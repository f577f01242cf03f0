#pragma once

#include <vector>

#include "estimation/pose_constraints.hpp"
#include "problem/objective.hpp"
#include "problem/pair_filter.hpp"
#include "problem/run.hpp"

namespace gmcr::search {

/// What a method found and proved.
struct MethodResult {
  std::vector<Similarity> poses;  ///< between the centred frames, the best first; empty: none
  /// Proven: no admitted pose has more inliers; with one-to-one, of which no two share a point.
  Index upper_bound = 0;
  double evidence_upper_bound = 0;  ///< the same for their evidence
};

/// `Method::Gmcr`: candidate cliques judged by the objective, bounds from cliques and, where the
/// options ask for it, from the joint search. Then the same again without the consensus sets found,
/// for further hypotheses.
/// @param filter  what the priors and one-to-one say of pairs.
MethodResult solve_gmcr(problem::SolveContext& context, const problem::Objective& objective,
                        const estimation::PoseConstraints& constraints,
                        const problem::PairFilter& filter);

}  // namespace gmcr::search
