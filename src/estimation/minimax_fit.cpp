#include "estimation/minimax_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "estimation/constrained_fit.hpp"

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
  const double mean = (weights_ * residuals_.square()).sum() / weights_.sum();
  lower_bound_ = std::max(lower_bound_, std::sqrt(mean));
  // a floor, so that a point that fits well now can come back
  weights_ *= residuals_.max(1e-3);
  weights_ = (weights_ / weights_.maxCoeff()).max(1e-12);
  return true;
}

}  // namespace gmcr
