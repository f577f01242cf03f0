#pragma once

#include <Eigen/Core>

#include "estimation/closed_forms/moments.hpp"
#include "estimation/fits/pose_constraints.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {

/// Fits that approach the similarity whose largest relative residual |b_i - (s R a_i + t)| / eps_i
/// is least (Lawson 1961): weighted least squares, where each weight is multiplied by its relative
/// residual.
///
/// Of any transform the weighted mean of the squares is at most the square of the largest. So the
/// least mean of all transforms bounds the least largest residual from below, and where it exceeds
/// 1 no transform holds all of the points, wherever it is (L5).
class MinimaxFit {
 public:
  /// @param source, target  3 x M, metres.  @param bounds  M bounds eps_i, metres, > 0.
  MinimaxFit(const PointsRef& source, const PointsRef& target, const Eigen::ArrayXd& bounds,
             PoseConstraints constraints);

  /// One more fit. @return false where there is none: of too few points. Cost O(M).
  bool step();

  /// Leaves point k out of the fits to come; those behind it move up by one. The bound goes on from
  /// nothing. Cost O(M).
  void leave_out(Index k);

  const Similarity& pose() const { return pose_; }                ///< of the last fit
  const Eigen::ArrayXd& residuals() const { return residuals_; }  ///< relative, at `pose()`
  const Eigen::ArrayXd& weights() const { return weights_; }      ///< of the next fit, at most 1
  double mean_square() const { return mean_square_; }  ///< of the residuals, weighted as in the fit

  /// No transform with a scale in the range, whatever the priors, has a largest relative residual
  /// below this, the most that the fits so far prove. Cost O(M).
  double lower_bound();

 private:
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd inverse_squared_bounds_;
  PoseConstraints constraints_;
  Similarity pose_;
  Moments moments_;  // of the last fit
  Eigen::ArrayXd residuals_, weights_;
  double sum_of_weights_ = 0, mean_square_ = 0, lower_bound_ = 0;
};

}  // namespace gmcr::estimation
