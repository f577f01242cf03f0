#pragma once

#include <optional>
#include <vector>

#include "estimation/pose_constraints.hpp"
#include "geometry/correspondence_arrays.hpp"
#include "gmcr/options.hpp"
#include "problem/correspondences.hpp"
#include "problem/objective.hpp"
#include "problem/pair_filter.hpp"
#include "problem/run.hpp"
#include "problem/scale_buckets.hpp"

namespace gmcr::problem {

/// One problem, as all of a solve sees it: what was given, in the layouts and with the bounds that
/// the stages read. Nothing of it changes once it is built.
///
/// The priors on the translation admit some of the input's correspondences; the others are left out
/// of all but `input()`. The admitted ones have numbers of their own, from 0 to size() - 1.
class Problem {
 public:
  /// Keeps references to the points and the options.
  /// @param source, target, options  valid, with a noise bound.
  /// @throws std::invalid_argument where the consistency graph exceeds the memory budget.
  /// Cost O(N log N), and the pairs of near targets for distinct evidence.
  Problem(const PointsRef& source, const PointsRef& target, const Options& options, Run& run);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  const Options& options() const { return options_; }

  /// All of the caller's correspondences.
  const CallerCorrespondences& input() const { return input_; }

  Index size() const { return size_; }

  /// Whether the admitted correspondences are too few for a pose: all that follows is empty then.
  bool is_too_small() const { return size_ < kMinInliers; }

  const Correspondences& correspondences() const { return correspondences_; }
  const ScaleRange& scales() const { return constraints_.scales; }
  bool scale_is_known() const { return scales().min == scales().max; }
  const ScaleBuckets& buckets() const { return buckets_; }

  /// What a pose must satisfy.
  const estimation::PoseConstraints& constraints() const { return constraints_; }

  /// Eq. (2): what is maximised.
  const Objective& objective() const { return *objective_; }

  /// Which pairs the priors and one-to-one admit.
  const PairFilter& filter() const { return *filter_; }

  /// For the consistency graphs: the bounds cover the rounding of residuals, so that two inliers of
  /// one pose are never without an edge.
  const geometry::CorrespondenceArrays& arrays() const { return arrays_; }

 private:
  const Options& options_;
  CallerCorrespondences input_;
  Index size_ = 0;
  Correspondences correspondences_;
  ScaleBuckets buckets_;
  estimation::PoseConstraints constraints_;
  std::optional<Objective> objective_;
  std::optional<PairFilter> filter_;
  geometry::CorrespondenceArrays arrays_;
};

/// What a search found: poses, the best one first, and what they leave possible.
struct Found {
  std::vector<CentredPose> poses;
  Index upper_bound = 0;            ///< proven: no admitted pose has more inliers
  double evidence_upper_bound = 0;  ///< proven: no admitted pose has more evidence
};

}  // namespace gmcr::problem
