#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "noise/chance.hpp"

namespace gmcr::noise {

/// How near to each other points lie by chance: distances of pairs of points, all of them or an
/// even selection, without those that coincide.
class PairDistances {
 public:
  static constexpr Index kMaxPairs = 100'000;

  /// Of the points of one cloud.
  /// @param max_pairs  about; at least 4 for each point.
  explicit PairDistances(const PointsRef& points, Index max_pairs = kMaxPairs)
      : PairDistances(points, points, max_pairs) {}

  /// Of a point of one cloud and one of another that is not its partner; as many columns each.
  PairDistances(const PointsRef& points, const PointsRef& others, Index max_pairs = kMaxPairs);

  bool empty() const { return sorted_.empty(); }

  /// Median distance, metres; 0 where all points coincide.
  double median() const;

  /// Share of the pairs that are at most `radius` apart, in (0, 1]. Below the shortest distances it
  /// falls with the power of the radius that these follow: 2 on surfaces, 3 in volumes.
  double share_within(double radius) const;

 private:
  std::vector<double> sorted_;
  Tail tail_;
};

/// How surely each set of correspondences of least residual is no work of chance. Entry m speaks of
/// the k = m + 4 of them.
struct FalseAlarms {
  std::vector<double> residuals;  ///< the largest of the set, metres; ascending
  std::vector<double> log10;      ///< of the number of false alarms

  bool empty() const { return log10.empty(); }
};

/// False alarms of the consensus sets of a pose, without a noise bound:
///   NFA(k) = (N - 3) C(N, k) C(k, 3) alpha_k^(k - 3),
/// the expected number of sets of k as tight among random correspondences (Moisan and Stival 2004;
/// AC-RANSAC: Moulon et al. 2012). alpha_k is the chance that a random correspondence is within the
/// k-th residual.
///
/// Deviation: alpha_k comes from how near the points of the clouds lie to each other, the larger of
/// the shares in the target's and in the source's frame, and not from the volume of a box: it holds
/// for flat and uneven scenes, and a pose that shrinks the source onto a point explains nothing. It
/// is at most the share of the images of the sources that lie as near to a target that is not
/// theirs: a cluster of wrong targets draws nothing to itself where no image is.
/// @param residuals  N values, metres.
/// @param between    distances of targets and images.
/// @param rounding   metres, > 0: a residual below it counts as that.
/// @return empty where N <= 3: nothing is unlikely then.
/// Cost O(N log N).
FalseAlarms count_false_alarms(const Eigen::ArrayXd& residuals, double scale,
                               const PairDistances& source, const PairDistances& target,
                               const PairDistances& between, double rounding);

/// How sure poses of the same correspondences are without a noise bound, roughly and fast: the
/// least log10 of the false alarms of their consensus sets, by 10,000 distances of pairs.
class PoseAlarms {
 public:
  /// @param source, target  N correspondences.
  PoseAlarms(const PointsRef& source, const PointsRef& target);

  /// Least log10 of `count_false_alarms`; 0 where N <= 3. Cost O(N log N).
  double least_log10(const Similarity& pose) const;

 private:
  Points source_, target_;
  PairDistances source_distances_, target_distances_;
  double rounding_;
};

}  // namespace gmcr::noise
