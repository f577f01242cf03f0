#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/types.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::paper {

/// An unordered pair of correspondences, first < second.
struct Pair {
  Index first = 0, second = 0;
};

/// Translation invariant measurements, Eq. (4): differences of point pairs, which decouple scale
/// and rotation from the translation.
struct Tims {
  std::vector<Pair> pairs;
  Points source, target;  ///< 3 x K: abar_k = a_second - a_first, bbar_k likewise, metres
  Eigen::ArrayXd bounds;  ///< K values: eps_k = eps_first + eps_second, metres

  Index size() const { return source.cols(); }
};

/// TIMs of the given pairs. Cost O(K).
Tims make_tims(const problem::Correspondences& correspondences, std::vector<Pair> pairs);

/// The TIMs with the given numbers, in that order.
Tims select(const Tims& tims, const std::vector<Index>& indices);

/// Correspondences that the given TIMs touch, ascending.
std::vector<Index> touched_correspondences(const Tims& tims, const std::vector<Index>& indices);

/// All N (N - 1) / 2 pairs in lexicographic order.
std::vector<Pair> all_pairs(Index num_correspondences);

/// Largest m with m (m - 1) / 2 <= num_pairs: m inliers need that many agreeing pairs (L5).
Index max_members(Index num_pairs);

/// Scale measurements of the TIMs, Eq. (9): ratios of lengths, which decouple the scale from the
/// rotation; and their intervals (L1).
struct ScaleMeasurements {
  Eigen::ArrayXd scale;         ///< s_k = |bbar_k| / |abar_k|; infinite where abar_k = 0
  Eigen::ArrayXd alpha;         ///< alpha_k = eps_k / |abar_k|; infinite where abar_k = 0
  Eigen::ArrayXd lower, upper;  ///< [s_k - alpha_k, s_k + alpha_k], all of R or empty (lower >
                                ///< upper) where abar_k = 0
};

/// Deviation: Eq. (11) multiplies alpha_k by the threshold c where the objective that it comes
/// from, Eq. (10), divides by c. Here c = 1.
ScaleMeasurements measure_scales(const Tims& tims);

}  // namespace gmcr::paper
