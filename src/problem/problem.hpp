#pragma once

#include <optional>
#include <vector>

#include "estimation/fits/pose_constraints.hpp"
#include "geometry/correspondence_arrays.hpp"
#include "gmcr/options.hpp"
#include "problem/correspondences.hpp"
#include "problem/graph/pair_filter.hpp"
#include "problem/objective/objective.hpp"
#include "problem/run.hpp"
#include "problem/scale_buckets.hpp"

namespace gmcr::problem {

/// Seconds that the graphs of a search among so many correspondences take, about: times are weighed
/// by it without a clock, so that the same input has the same answer on any machine.
inline double foreseen_seconds(Index num_correspondences, bool scale_is_known) {
  constexpr double kOfAPair = 6e-10, kScales = 10;
  const auto n = static_cast<double>(num_correspondences);
  return kOfAPair * n * n / 2 * (scale_is_known ? 1 : kScales);
}

/// So many correspondences have their graph in milliseconds: it is built whatever the time, so that
/// there is a pose to offer.
inline constexpr Index kQuickGraph = 4096;

/// A search of fewer out of more correspondences tells nothing of these.
inline constexpr Index kLeastSample = 1024;

/// Whether a problem may be too large for its memory and time, so that a sample of it is searched.
enum class Route { Any, Whole };

/// One problem, as all of a solve sees it: what was given, in the layouts and with the bounds that
/// the stages read. Nothing of it changes once it is built.
///
/// The priors on the translation admit some of the input's correspondences; the others are left out
/// of all but `input()`. The admitted ones have numbers of their own, from 0 to size() - 1.
class Problem {
 public:
  /// Where a sample is searched, only what judges poses is built: `filter` and `arrays` are empty,
  /// and inliers are counted.
  /// Keeps references to the points and the options.
  /// @param source, target, options  valid, with a noise bound.
  /// @throws std::invalid_argument where the memory budget does not suffice for a graph of a sample
  ///   either, and for the graph of all where the method is that of the paper.
  /// Cost O(N log N), and the pairs of near targets for distinct evidence.
  Problem(const PointsRef& source, const PointsRef& target, const Options& options, Run& run,
          Route route = Route::Any);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  const Options& options() const { return options_; }

  /// All of the caller's correspondences.
  const CallerCorrespondences& input() const { return input_; }

  Index size() const { return size_; }

  /// Whether the admitted correspondences are too few for a pose: all that follows is empty then.
  bool is_too_small() const { return size_ < min_inliers(); }

  /// Inliers that determine a pose, with what is known of it.
  Index min_inliers() const { return min_inliers_; }

  /// Whether the memory or the time is far from sufficing for a consistency graph of all of them,
  /// so that a sample is searched; never on `Route::Whole`. The method of the paper has no such
  /// route.
  bool is_sampled() const { return is_sampled_; }

  /// Whether the time hardly suffices for some passes over all of them.
  bool is_hurried() const;

  /// Those of the given correspondences whose residuals are not all rounding: what is far enough
  /// out agrees with most others and says nothing of a pose. All of them where hardly any is left.
  std::vector<Index> clear_of_rounding(const std::vector<Index>& indices) const;

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
  Index min_inliers_ = kMinInliers;
  Index size_ = 0;
  bool is_sampled_ = false;
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
