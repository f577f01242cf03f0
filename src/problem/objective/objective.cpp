#include "problem/objective/objective.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "kernels/points/residuals.hpp"

namespace gmcr::problem {

bool shares_most(const std::vector<Index>& a, const std::vector<Index>& b) {
  std::vector<Index> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  return 2 * shared.size() > std::min(a.size(), b.size());
}

template <Frame frame>
ObjectiveIn<frame>::ObjectiveIn(const CorrespondencesIn<frame>& correspondences, Evidence evidence,
                                std::size_t max_bytes, const ScaleRange& scales,
                                const ScaleBuckets& buckets, const parallel::Deadline& deadline,
                                const CallerCorrespondences* as_given)
    : correspondences_(correspondences),
      source_(correspondences.source.transpose()),
      target_(correspondences.target.transpose()),
      squared_bounds_(correspondences.bounds.square()) {
  if (evidence == Evidence::Distinct) {
    const PointsRef source = as_given ? as_given->source : PointsRef(correspondences.source);
    const PointsRef target = as_given ? as_given->target : PointsRef(correspondences.target);
    distinct_.emplace(source, target, correspondences.bounds, max_bytes, buckets, scales, deadline);
  }
  if (is_weighted() && distinct_->depends_on_scale()) return;
  weights_.setOnes(correspondences.size());
  if (!is_weighted()) return;
  for (Index i = 0; i < weights_.size(); ++i) weights_[i] = distinct_->weight(i, scales.min);
}

template <Frame frame>
double ObjectiveIn<frame>::evidence_of(const std::vector<Index>& indices, double scale) const {
  double evidence = 0;
  for (const Index i : indices) evidence += weight(i, scale);
  return evidence;
}

template <Frame frame>
std::vector<Index> ObjectiveIn<frame>::within(const PoseIn<frame>& pose, double factor) const {
  return kernels::consensus(pose.similarity, source_, target_, squared_bounds_, factor * factor)
      .indices;
}

template <Frame frame>
HypothesisIn<frame> ObjectiveIn<frame>::judge(const PoseIn<frame>& pose) const {
  // Eq. (3): { i : |b_i - (s R a_i + t)| <= eps_i }
  kernels::Consensus consensus =
      kernels::consensus(pose.similarity, source_, target_, squared_bounds_);
  HypothesisIn<frame> hypothesis;
  hypothesis.pose = pose;
  hypothesis.inliers = std::move(consensus.indices);
  // Eq. (2), L6: the sum of w_i(s) over I in place of its size
  hypothesis.evidence = evidence_of(hypothesis.inliers, pose.scale());
  // each of the others adds 1
  hypothesis.quadratic = static_cast<double>(squared_bounds_.size() - hypothesis.num_inliers());
  for (std::size_t k = 0; k < hypothesis.inliers.size(); ++k) {
    hypothesis.quadratic += consensus.squared_residuals[k] / squared_bounds_[hypothesis.inliers[k]];
  }
  return hypothesis;
}

template class ObjectiveIn<Frame::Centred>;
template class ObjectiveIn<Frame::Caller>;

}  // namespace gmcr::problem
