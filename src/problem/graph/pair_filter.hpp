#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "gmcr/priors.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::problem {

/// What is known beforehand, as a test of single pairs: which pairs can be inliers of one pose that
/// the priors admit, and, one-to-one, share no end point.
///
/// A prior on the rotation bounds the angle delta between R abar_k and bbar_k from below: gravity
/// by | angle(bbar_k, target) - angle(abar_k, source) | - max_tilt, an initial rotation R0 by
/// angle(bbar_k, R0 abar_k) - max_rotation. The pair is admitted iff bbar_k is within eps_k of a
/// point at the angle delta from it, at a radius in [s1 |abar_k|, s2 |abar_k|]. With delta = 0 that
/// is L1.
///
/// A prior on the translation is a correspondence too: the origin of the source frame maps to t, so
/// |t - t0| <= T says that origin -> t0 is an inlier of bound T. What has no edge to it is no
/// inlier of any admitted pose.
///
/// No true edge is lost to rounding, in the same sense as in `consistency_arrays`.
class PairFilter {
 public:
  /// @param priors  valid, of the transform between the caller's frames.
  /// @param scales  the widest range of scales that is asked for.
  /// Cost O(N log N).
  PairFilter(const Correspondences& correspondences, const Priors& priors, bool one_to_one,
             const ScaleRange& scales);

  /// Whether nothing is known: all that L1 admits is admitted.
  bool is_empty() const { return angles_.empty() && num_virtual_ == 0 && !one_to_one_; }

  /// Whether some pose with a scale in the range that the priors on the translation and the
  /// rotation admit can have correspondence i as an inlier.
  bool admits(Index i, const ScaleRange& scales) const;

  /// Whether some pose with a scale in the range that the priors on the rotation admit can have
  /// both as inliers, and both are wanted.
  bool admits_pair(Index i, Index j, const ScaleRange& scales) const;

  /// Removes the edges that are not admitted from a consistency graph of the range of scales.
  /// Where the deadline passes before the end, all are. Deterministic. Cost O(N^2 / 64 + edges).
  void apply(BitsetGraph& graph, const ScaleRange& scales, int num_threads,
             const parallel::Deadline& deadline = parallel::Deadline::never()) const;

  /// A maximal subset of `indices` of which no two share an end point, the earliest first; all of
  /// them where sharing is not forbidden.
  std::vector<Index> one_to_one(const std::vector<Index>& indices) const;

 private:
  /// A prior on the rotation, in frames where it is simple: gravity is the last axis of both, or
  /// the initial rotation is the identity.
  struct AnglePrior {
    bool about_axis = false;      ///< gravity; else an initial rotation
    double cosine = 1, sine = 0;  ///< of the largest tilt or rotation
    /// Source, target, bound and padding of each correspondence: what a pair needs of it in one
    /// cache line.
    Eigen::Matrix<double, 8, Eigen::Dynamic> ends;

    bool admits(Index i, Index j, const ScaleRange& scales) const;
  };

  void add(bool about_axis, double angle, const Eigen::Matrix3d& source_turn,
           const Eigen::Matrix3d& target_turn, const Eigen::ArrayXd& rounding);
  bool admits_rotation(Index i, Index j, const ScaleRange& scales) const;
  bool share_end_point(Index i, Index j) const;

  geometry::CorrespondenceArrays arrays_;  ///< the correspondences, then the virtual ones
  Index num_correspondences_ = 0, num_virtual_ = 0;
  std::vector<AnglePrior> angles_;
  bool one_to_one_ = false;
  std::vector<Index> source_point_, target_point_;  ///< equal where the coordinates are
};

}  // namespace gmcr::problem
