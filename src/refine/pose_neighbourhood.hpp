#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimation/pose_constraints.hpp"
#include "problem/objective.hpp"

namespace gmcr::refine {

/// What decides between poses near each other.
struct Score {
  double evidence = 0;
  double quadratic = 0;  ///< as of `Hypothesis`, of the correspondences near them alone

  bool is_better_than(const Score& other) const {
    if (evidence != other.evidence) return evidence > other.evidence;
    return quadratic < other.quadratic;
  }
};

/// Correspondences near a pose, copied into columns: fits that stay near it look at no others.
class NearSet {
 public:
  /// Those whose residual at the pose is at most `factor` times their bound. Keeps a reference to
  /// the objective. Cost O(N).
  NearSet(const problem::Objective& objective, const Similarity& pose, double factor);

  const problem::Objective& objective() const { return objective_; }
  const std::vector<Index>& indices() const { return indices_; }  ///< ascending

  /// Squared residuals over squared bounds. Cost O(M) for the M in the set, as of all below.
  Eigen::ArrayXd relative_squares(const Similarity& pose) const;

  /// Fit to those whose entry of `relative_squares` is at most factor^2.
  /// @return nullopt where they are fewer than 3, and where no admitted pose is found.
  std::optional<Similarity> fit(const Eigen::ArrayXd& relative_squares, double factor,
                                const estimation::PoseConstraints& constraints) const;

  /// Those whose entry of `relative_squares` is at most factor^2, ascending.
  std::vector<Index> within(const Eigen::ArrayXd& relative_squares, double factor) const;

  /// Evidence of those whose entry of `relative_squares` is at most factor^2.
  double evidence(const Eigen::ArrayXd& relative_squares, double factor, double scale) const;

  /// Score of a pose of the given scale.
  Score score(const Eigen::ArrayXd& relative_squares, double scale) const;

 private:
  const problem::Objective& objective_;
  std::vector<Index> indices_;
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd inverse_squared_bounds_;
  Eigen::ArrayXd weights_;  ///< where they do not depend on the scale
};

}  // namespace gmcr::refine
