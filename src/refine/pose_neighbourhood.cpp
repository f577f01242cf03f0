#include "refine/pose_neighbourhood.hpp"

#include "estimation/closed_forms/moments.hpp"
#include "estimation/fits/constrained_fit.hpp"
#include "kernels/points/residuals.hpp"

namespace gmcr::refine {

namespace {

/// Sum of term(k) for all k < count, in a fixed order that vector registers can follow.
template <typename Term>
double sum_in_lanes(Index count, const Term& term) {
  constexpr Index kLanes = 4;
  double lanes[kLanes] = {};
  Index k = 0;
  for (; k + kLanes <= count; k += kLanes) {
    for (Index lane = 0; lane < kLanes; ++lane) lanes[lane] += term(k + lane);
  }
  for (; k < count; ++k) lanes[0] += term(k);
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

}  // namespace

PoseNeighbourhood::PoseNeighbourhood(const problem::Problem& problem,
                                     const problem::CentredPose& pose, double factor)
    : problem_(problem),
      indices_(problem.objective().within(pose, factor)),
      source_(problem.correspondences().source(Eigen::all, indices_).transpose()),
      target_(problem.correspondences().target(Eigen::all, indices_).transpose()),
      inverse_squared_bounds_(problem.correspondences().bounds(indices_).square().inverse()) {
  if (problem.objective().weights_depend_on_scale()) return;
  weights_.resize(static_cast<Index>(indices_.size()));
  for (Index k = 0; k < weights_.size(); ++k) {
    weights_[k] = problem.objective().weight(indices_[static_cast<std::size_t>(k)], 1);
  }
}

Eigen::ArrayXd PoseNeighbourhood::relative_squares(const problem::CentredPose& pose) const {
  return kernels::squared_residuals(pose.similarity, source_, target_) * inverse_squared_bounds_;
}

std::optional<problem::CentredPose> PoseNeighbourhood::fit(const Eigen::ArrayXd& weights) const {
  if ((weights > 0).count() < problem_.min_inliers()) return std::nullopt;
  const auto fit = estimation::fit_pose(
      estimation::measure_moments(source_, target_, weights * inverse_squared_bounds_),
      problem_.constraints());
  if (!fit) return std::nullopt;
  return problem::CentredPose{*fit};
}

std::optional<problem::CentredPose> PoseNeighbourhood::fit(const Eigen::ArrayXd& relative_squares,
                                                           double factor) const {
  return fit((relative_squares <= factor * factor).cast<double>());
}

std::vector<Index> PoseNeighbourhood::within(const Eigen::ArrayXd& relative_squares,
                                             double factor) const {
  std::vector<Index> chosen;
  for (Index k = 0; k < relative_squares.size(); ++k) {
    if (!(relative_squares[k] <= factor * factor)) continue;
    chosen.push_back(indices_[static_cast<std::size_t>(k)]);
  }
  return chosen;
}

double PoseNeighbourhood::evidence(const Eigen::ArrayXd& relative_squares, double factor,
                                   double scale) const {
  const double limit = factor * factor;
  const Index count = relative_squares.size();
  if (problem_.objective().weights_depend_on_scale()) {
    double evidence = 0;
    for (Index k = 0; k < count; ++k) {
      if (!(relative_squares[k] <= limit)) continue;
      evidence += problem_.objective().weight(indices_[static_cast<std::size_t>(k)], scale);
    }
    return evidence;
  }
  return sum_in_lanes(count, [&](Index k) {
    const double weight = weights_[k];  // read in any case: no branch
    return relative_squares[k] <= limit ? weight : 0;
  });
}

Score PoseNeighbourhood::score(const Eigen::ArrayXd& relative_squares, double scale) const {
  return {evidence(relative_squares, 1, scale), sum_in_lanes(relative_squares.size(), [&](Index k) {
            return relative_squares[k] < 1 ? relative_squares[k] : 1;
          })};
}

}  // namespace gmcr::refine
