#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimation/pose_constraints.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr {

/// Fits that approach the similarity whose largest relative residual |b_i - (s R a_i + t)| / eps_i
/// is least (Lawson 1961): weighted least squares, where each weight is multiplied by its relative
/// residual.
///
/// Without priors, the weighted mean of the squares at each fit is a lower bound on the square of
/// the least largest one, since no transform has a smaller mean. So a bound above 1 proves that no
/// transform holds all of the points, wherever it is.
class MinimaxFit {
 public:
  /// @param source, target  3 x M, metres.  @param bounds  M bounds eps_i, metres, > 0.
  MinimaxFit(Points source, Points target, Eigen::ArrayXd bounds,
             const PoseConstraints& constraints);

  /// One more fit. @return false where there is none: of fewer than 3 points. Cost O(M).
  bool step();

  const Similarity& pose() const { return pose_; }                ///< of the last fit
  const Eigen::ArrayXd& residuals() const { return residuals_; }  ///< relative, at `pose()`
  const Eigen::ArrayXd& weights() const { return weights_; }      ///< of the next fit, at most 1
  /// No transform's largest one is below, where the constraints have no priors.
  double lower_bound() const { return lower_bound_; }

 private:
  Points source_, target_;
  Eigen::ArrayXd bounds_;
  PoseConstraints constraints_;
  std::vector<Index> all_;
  Similarity pose_;
  Eigen::ArrayXd residuals_, weights_;
  double lower_bound_ = 0;
};

}  // namespace gmcr
