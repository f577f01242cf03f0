#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"
#include "problem/scale_buckets.hpp"

namespace gmcr::problem {

/// Weights of distinct evidence (L6).
///
/// A pair with |bbar_k| <= eps_k and s |abar_k| <= eps_k leaves every scale up to s and a cone of
/// 60 degrees of rotation, and one a little longer not much less: its two members say one thing
/// twice. Correspondence i weighs
///   w_i(s) = 1 / (1 + number of its copies at scale s),
/// copies being the pairs with |bbar_k| <= kCopyRadius e_k and o |abar_k| <= kCopyRadius e_k, where
/// e_k = 2 min(eps_i, eps_j) is eps_k where bounds are alike: a match of loose bound is no copy of
/// the tight ones in its ball, which say much more; and where o is the centre of the bucket of s:
/// were it s itself, copies would be lost one by one as s grows, and the pose of most evidence
/// would be one whose scale is some per cent too large.
class DistinctEvidence {
 public:
  /// Copies at half as much again as the 1 of L6 tell clusters of outliers from inliers where
  /// these are few; farther ones would take dense inliers for copies.
  static constexpr double kCopyRadius = 1.5;

  static constexpr ScaleRange kAllScales{0, std::numeric_limits<double>::infinity()};

  /// Finds all pairs that can be copies at some scale in the range. Cost O(N log N + pairs of
  /// near targets).
  /// @param max_bytes  for the pairs of near targets, as if all were listed. Where it does not
  ///   suffice, `complete()` is false and every weight is 1.
  /// @param deadline   where it passes first, so it is.
  /// @param scales     at which weights are asked for; in one bucket nothing is listed.
  DistinctEvidence(const PointsRef& source, const PointsRef& target, const Eigen::ArrayXd& bounds,
                   std::size_t max_bytes, const ScaleBuckets& buckets,
                   const ScaleRange& scales = kAllScales,
                   const parallel::Deadline& deadline = parallel::Deadline::never());

  bool complete() const { return complete_; }

  /// Whether any weight is less than 1 at some scale.
  bool has_copies() const { return has_copies_; }

  /// Whether a weight differs from scale to scale in the range.
  bool depends_on_scale() const { return !max_scales_.empty(); }

  /// w_i(scale), of the nearest scale in the range; it does not fall as the scale grows. Cost
  /// O(log number of copies).
  double weight(Index i, double scale) const;

 private:
  ScaleBuckets buckets_;
  bool complete_ = true;
  bool has_copies_ = false;
  std::vector<Index> always_;       ///< copies at every scale in the range
  std::vector<std::size_t> first_;  ///< N + 1 offsets into max_scales_
  /// Per correspondence, descending: up to which scale one of the other copies is one.
  std::vector<double> max_scales_;
};

}  // namespace gmcr::problem
