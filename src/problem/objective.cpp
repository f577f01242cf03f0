#include "problem/objective.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "kernels/residuals.hpp"

namespace gmcr::problem {

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
                     std::size_t max_bytes, const ScaleRange& scales, const Octaves& octaves)
    : correspondences_(correspondences),
      octaves_(octaves),
      source_(correspondences.source.transpose()),
      target_(correspondences.target.transpose()),
      squared_bounds_(correspondences.bounds.square()) {
  if (evidence == Evidence::Distinct) {
    distinct_.emplace(correspondences, max_bytes, octaves, scales);
  }
  if (is_weighted() && distinct_->depends_on_scale()) return;
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
  return kernels::consensus(target_from_source, source_, target_, squared_bounds_, factor * factor)
      .indices;
}

Hypothesis Objective::judge(const Similarity& target_from_source) const {
  kernels::Consensus consensus =
      kernels::consensus(target_from_source, source_, target_, squared_bounds_);
  Hypothesis hypothesis;
  hypothesis.target_from_source = target_from_source;
  hypothesis.inliers = std::move(consensus.indices);
  hypothesis.evidence = evidence_of(hypothesis.inliers, target_from_source.scale);
  // each of the others adds 1
  hypothesis.quadratic = static_cast<double>(squared_bounds_.size() - hypothesis.num_inliers());
  for (std::size_t k = 0; k < hypothesis.inliers.size(); ++k) {
    hypothesis.quadratic += consensus.squared_residuals[k] / squared_bounds_[hypothesis.inliers[k]];
  }
  return hypothesis;
}

}  // namespace gmcr::problem
