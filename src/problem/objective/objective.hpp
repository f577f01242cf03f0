#pragma once

#include <optional>
#include <vector>

#include "gmcr/options.hpp"
#include "problem/correspondences.hpp"
#include "problem/objective/distinct_evidence.hpp"

namespace gmcr::problem {

/// That determine a pose of which nothing is known, and its noise; `Problem::min_inliers`.
constexpr Index kMinInliers = 3;

/// A pose with all that the objective says of it.
template <Frame frame>
struct HypothesisIn {
  PoseIn<frame> pose;
  std::vector<Index> inliers;  ///< its consensus set, ascending
  double evidence = 0;         ///< sum of the weights of the inliers: what is maximised
  double quadratic = 0;        ///< sum over all of min(residual^2 / eps^2, 1): decides ties

  Index num_inliers() const { return static_cast<Index>(inliers.size()); }
};
using Hypothesis = HypothesisIn<Frame::Centred>;
using CallerHypothesis = HypothesisIn<Frame::Caller>;

/// Whether `a` is the better answer: more evidence, or as much with a closer fit.
template <Frame frame>
bool is_better(const HypothesisIn<frame>& a, const HypothesisIn<frame>& b) {
  if (a.evidence != b.evidence) return a.evidence > b.evidence;
  return a.quadratic < b.quadratic;
}

/// Whether two consensus sets, ascending, are of the same pose: they share more than half of the
/// smaller one.
bool shares_most(const std::vector<Index>& a, const std::vector<Index>& b);

/// The objective itself, on all correspondences: Eq. (2), with the weights of L6.
template <Frame frame>
class ObjectiveIn {
 public:
  /// Keeps a reference to `correspondences`.
  /// @param max_bytes  memory that the evidence weights may take.
  /// @param scales     where the scale of all poses lies; in one bucket a weight costs nothing.
  /// @param buckets    by which the weights differ.
  /// @param deadline   where it passes first, each weight is 1, as where the memory does not
  /// suffice.
  /// @param as_given   the same matches with all their digits, by which copies are told: frames
  /// that are far out have rounded some away. Null: as they are here.
  ObjectiveIn(const CorrespondencesIn<frame>& correspondences, Evidence evidence,
              std::size_t max_bytes, const ScaleRange& scales = DistinctEvidence::kAllScales,
              const ScaleBuckets& buckets = ScaleBuckets(1),
              const parallel::Deadline& deadline = parallel::Deadline::never(),
              const CallerCorrespondences* as_given = nullptr);

  const CorrespondencesIn<frame>& correspondences() const { return correspondences_; }

  /// Evidence that correspondence i gives at a scale, in (0, 1].
  double weight(Index i, double scale) const {
    return weights_.size() > 0 ? weights_[i] : distinct_->weight(i, scale);
  }

  /// Whether some correspondence gives less evidence than 1 at some scale.
  bool is_weighted() const { return distinct_ && distinct_->has_copies(); }

  /// Whether weights differ from scale to scale.
  bool weights_depend_on_scale() const { return weights_.size() != correspondences_.size(); }

  /// Evidence that the given correspondences give together at a scale.
  double evidence_of(const std::vector<Index>& indices, double scale) const;

  /// Whether memory and time sufficed for the weights; if not, each is 1.
  bool weights_complete() const { return !distinct_ || distinct_->complete(); }

  /// Correspondences whose residual is at most `factor` times their bound, ascending.
  std::vector<Index> within(const PoseIn<frame>& pose, double factor) const;

  /// Consensus set and score of a pose.
  HypothesisIn<frame> judge(const PoseIn<frame>& pose) const;

 private:
  const CorrespondencesIn<frame>& correspondences_;
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd squared_bounds_;
  std::optional<DistinctEvidence> distinct_;
  Eigen::ArrayXd weights_;  ///< where they do not depend on the scale
};
using Objective = ObjectiveIn<Frame::Centred>;
using CallerObjective = ObjectiveIn<Frame::Caller>;

}  // namespace gmcr::problem
