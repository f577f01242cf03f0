#pragma once

#include <optional>
#include <vector>

#include "problem/problem.hpp"

namespace gmcr::refine {

/// The best pose so far, which others have to beat.
struct Incumbent {
  const problem::Hypothesis* best = nullptr;  ///< null: none yet
  bool is_exhausted = false;  ///< many poses near it were no better: no more are tried

  double evidence() const { return best ? best->evidence : 0; }

  /// Whether a consensus set is of a pose near it. Small sets, and those of little evidence, share
  /// most of it by chance: nothing is near them.
  bool is_near(const std::vector<Index>& inliers) const {
    constexpr Index kMinMembers = 15;
    constexpr double kMinEvidence = 6;
    return best && best->num_inliers() >= kMinMembers && best->evidence >= kMinEvidence &&
           problem::shares_most(inliers, best->inliers);
  }
};

/// Best pose met while fitting to the consensus set of the pose, again and again: within 2 eps, 1.5
/// eps, then eps until the set no longer changes.
/// @param incumbent  where those within 1.5 eps give no more evidence after the first fit, that fit
/// is
///   the last; it is null where no pose is better than any.
/// @return never worse than `start` by the objective; nullopt where an exhausted incumbent is near.
std::optional<problem::Hypothesis> optimise_locally(const problem::Problem& problem,
                                                    const problem::CentredPose& start,
                                                    const Incumbent& incumbent = {});

/// Tries to bring correspondences just outside the consensus set inside it.
///
/// A least-squares pose leaves out inliers whose noise is close to the bound. Fits that weigh the
/// worst residuals up, iteration by iteration, approach the pose of least largest residual (Lawson
/// 1961); the correspondence that holds it back most is given up, and so on.
/// @param must_exceed  evidence of an incumbent: nothing is tried where all near give no
/// more.
/// @return never worse than `best` by the objective.
problem::Hypothesis hold_more(const problem::Problem& problem, problem::Hypothesis best,
                              double must_exceed = 0);

}  // namespace gmcr::refine
