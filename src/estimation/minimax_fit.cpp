#include "estimation/minimax_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "estimation/constrained_fit.hpp"
#include "estimation/moments.hpp"

namespace gmcr {

MinimaxFit::MinimaxFit(Points source, Points target, Eigen::ArrayXd bounds,
                       const PoseConstraints& constraints)
    : source_(std::move(source)),
      target_(std::move(target)),
      bounds_(std::move(bounds)),
      constraints_(constraints),
      all_(static_cast<std::size_t>(source_.cols())),
      weights_(Eigen::ArrayXd::Ones(source_.cols())) {
  std::iota(all_.begin(), all_.end(), Index{0});
}

bool MinimaxFit::step() {
  const auto fit = fit_pose(source_, target_, bounds_ / weights_.sqrt(), all_, constraints_);
  if (!fit) return false;
  pose_ = *fit;
  residuals_ = (target_ - pose_.apply(source_)).colwise().norm().transpose().array() / bounds_;
  fitted_weights_ = weights_;
  mean_square_ = (weights_ * residuals_.square()).sum() / weights_.sum();
  // a floor, so that a point that fits well now can come back
  weights_ *= residuals_.max(1e-3);
  weights_ = (weights_ / weights_.maxCoeff()).max(1e-12);
  return true;
}

double MinimaxFit::lower_bound() {
  if (mean_square_ <= lower_bound_ * lower_bound_) return lower_bound_;
  // the fit may miss the minimum where points are nearly collinear; its bound from below does not
  const Moments moments = measure_moments(source_, target_, bounds_ / fitted_weights_.sqrt(), all_);
  const double least = least_squares_bound(moments, constraints_.scales) / fitted_weights_.sum();
  lower_bound_ = std::max(lower_bound_, std::sqrt(least));
  return lower_bound_;
}

}  // namespace gmcr
