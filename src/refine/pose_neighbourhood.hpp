#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "problem/problem.hpp"

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
class PoseNeighbourhood {
 public:
  /// Those whose residual at the pose is at most `factor` times their bound. Keeps a reference to
  /// the problem. Cost O(N).
  PoseNeighbourhood(const problem::Problem& problem, const problem::CentredPose& pose,
                    double factor);

  const problem::Problem& problem() const { return problem_; }
  const std::vector<Index>& indices() const { return indices_; }  ///< ascending

  /// Squared residuals over squared bounds. Cost O(M) for the M in the set, as of all below.
  Eigen::ArrayXd relative_squares(const problem::CentredPose& pose) const;

  /// Fit with the given weights, each over the squared bound.
  /// @return nullopt where too few are above 0, and where no admitted pose is found.
  std::optional<problem::CentredPose> fit(const Eigen::ArrayXd& weights) const;

  /// Fit to those whose entry of `relative_squares` is at most factor^2.
  /// @return nullopt where they are too few, and where no admitted pose is found.
  std::optional<problem::CentredPose> fit(const Eigen::ArrayXd& relative_squares,
                                          double factor) const;

  /// Those whose entry of `relative_squares` is at most factor^2, ascending.
  std::vector<Index> within(const Eigen::ArrayXd& relative_squares, double factor) const;

  /// Evidence of those whose entry of `relative_squares` is at most factor^2.
  double evidence(const Eigen::ArrayXd& relative_squares, double factor, double scale) const;

  /// Score of a pose of the given scale.
  Score score(const Eigen::ArrayXd& relative_squares, double scale) const;

 private:
  const problem::Problem& problem_;
  std::vector<Index> indices_;
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd inverse_squared_bounds_;
  Eigen::ArrayXd weights_;  ///< where they do not depend on the scale
};

}  // namespace gmcr::refine
