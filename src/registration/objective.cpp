#include "registration/objective.hpp"

#include <algorithm>
#include <iterator>

#include "kernels/residuals.hpp"

namespace gmcr {

bool is_better(const Hypothesis& a, const Hypothesis& b) {
  if (a.evidence != b.evidence) return a.evidence > b.evidence;
  return a.quadratic < b.quadratic;
}

bool shares_most(const std::vector<Index>& a, const std::vector<Index>& b) {
  std::vector<Index> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  return 2 * shared.size() > std::min(a.size(), b.size());
}

Objective::Objective(const Correspondences& correspondences, Evidence evidence,
                     std::size_t max_bytes, const ScaleRange& scales)
    : correspondences_(correspondences),
      source_(correspondences.source.transpose()),
      target_(correspondences.target.transpose()),
      squared_bounds_(correspondences.bounds.square()) {
  if (evidence == Evidence::Distinct) distinct_.emplace(correspondences, max_bytes, scales);
  if (is_weighted() && scales.min < scales.max) return;
  weights_.setOnes(correspondences.size());
  if (!is_weighted()) return;
  for (Index i = 0; i < weights_.size(); ++i) weights_[i] = distinct_->weight(i, scales.min);
}

double Objective::evidence_of(const std::vector<Index>& indices, double scale) const {
  double evidence = 0;
  for (const Index i : indices) evidence += weight(i, scale);
  return evidence;
}

std::vector<Index> Objective::within(const Similarity& target_from_source, double factor) const {
  const Eigen::ArrayXd squared = kernels::squared_residuals(target_from_source, source_, target_);
  std::vector<Index> indices;
  for (Index i = 0; i < squared.size(); ++i) {
    if (squared[i] <= factor * factor * squared_bounds_[i]) indices.push_back(i);
  }
  return indices;
}

Hypothesis Objective::judge(const Similarity& target_from_source) const {
  Hypothesis hypothesis;
  hypothesis.target_from_source = target_from_source;
  const Eigen::ArrayXd squared = kernels::squared_residuals(target_from_source, source_, target_);
  for (Index i = 0; i < squared.size(); ++i) {
    const double relative = squared[i] / squared_bounds_[i];
    const bool is_inlier = relative <= 1;  // false also where it is not a number
    hypothesis.quadratic += is_inlier ? relative : 1;
    if (!is_inlier) continue;
    hypothesis.inliers.push_back(i);
    hypothesis.evidence += weight(i, target_from_source.scale);
  }
  return hypothesis;
}

}  // namespace gmcr
