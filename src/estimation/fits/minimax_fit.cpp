#include "estimation/fits/minimax_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimation/fits/constrained_fit.hpp"
#include "kernels/points/residuals.hpp"

namespace gmcr::estimation {

MinimaxFit::MinimaxFit(const PointsRef& source, const PointsRef& target,
                       const Eigen::ArrayXd& bounds, PoseConstraints constraints)
    : source_(source.transpose()),
      target_(target.transpose()),
      inverse_squared_bounds_(bounds.square().inverse()),
      constraints_(std::move(constraints)),
      weights_(Eigen::ArrayXd::Ones(source_.rows())) {}

bool MinimaxFit::step() {
  if (source_.rows() < min_correspondences(constraints_)) return false;
  moments_ = measure_moments(source_, target_, weights_ * inverse_squared_bounds_);
  const auto fit = fit_pose(moments_, constraints_);
  if (!fit) return false;
  pose_ = *fit;
  residuals_ = kernels::squared_residuals(pose_, source_, target_) * inverse_squared_bounds_;
  sum_of_weights_ = weights_.sum();
  mean_square_ = (weights_ * residuals_).sum() / sum_of_weights_;
  residuals_ = residuals_.sqrt();
  // a floor, so that a point that fits well now can come back
  weights_ *= residuals_.max(1e-3);
  weights_ = (weights_ / weights_.maxCoeff()).max(1e-12);
  return true;
}

void MinimaxFit::leave_out(Index k) {
  const Index behind = source_.rows() - k - 1;
  const auto close_up = [&](auto&& values) {
    values.segment(k, behind) = values.tail(behind).eval();
  };
  for (Index axis = 0; axis < 3; ++axis) {
    close_up(source_.col(axis));
    close_up(target_.col(axis));
  }
  for (Eigen::ArrayXd* values : {&inverse_squared_bounds_, &weights_, &residuals_}) {
    if (values->size() == 0) continue;
    close_up(*values);
    values->conservativeResize(k + behind);
  }
  source_.conservativeResize(k + behind, 3);
  target_.conservativeResize(k + behind, 3);
  mean_square_ = lower_bound_ = 0;
}

double MinimaxFit::lower_bound() {
  if (mean_square_ <= lower_bound_ * lower_bound_) return lower_bound_;
  // the fit may miss the minimum where points are nearly collinear; its bound from below does not
  const double least = least_squares_bound(moments_, constraints_.scales) / sum_of_weights_;
  lower_bound_ = std::max(lower_bound_, std::sqrt(least));
  return lower_bound_;
}

}  // namespace gmcr::estimation
