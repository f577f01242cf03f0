#pragma once

#include <cstddef>
#include <vector>

#include "gmcr/types.hpp"
#include "problem/correspondences.hpp"

namespace gmcr::noise {

/// Share of values at most a radius, below the least of them by the power law that these follow.
struct Tail {
  double radius = 0, share = 1, power = 1;

  /// @param low, high  the values of rank `low_rank` < `high_rank`, from 0, of `count` values.
  static Tail through(double low, std::size_t low_rank, double high, std::size_t high_rank,
                      std::size_t count);

  double share_within(double r) const;
};

/// Share of the values that are at most `radius`, in (0, 1]. Reorders the values.
/// Cost O(number of values).
double share_within(std::vector<double>& values, double radius);

/// What random correspondences of the same points do at a pose: the targets are dealt out anew
/// among the sources.
struct Chance {
  double inlier = 1;  ///< share of them within their bounds, alpha
  double length =
      1;  ///< share of pairs of them whose lengths agree at the scale of the pose, delta
};

/// Measures both on a selection of pairs of correspondences, which depends on their order and
/// number only. Targets that come in clusters, on lines or on planes are so by chance too.
/// Cost O(min(N, 20,000)).
Chance measure_chance(const problem::CallerCorrespondences& all, const problem::CallerPose& pose);

/// log10 of the expected number of consensus sets of at least k among n random correspondences:
///   NFA(k) = C(n, m) delta^c / C(k, m) P(X >= k - m),  X ~ Binomial(n - m, alpha),
/// the minimal samples that tell a pose, of which each set has C(k, m), times the chance that their
/// pose holds as many of the others (a contrario: Moisan and Stival 2004).
/// Deviation: alpha and delta are measured on the points, not on a box around them; delta says that
/// not any three correspondences have a pose.
/// @param k, n         m < k <= n for a number below 0; no whole numbers where copies count once.
/// @param sample_size  m: 3, or fewer where priors leave less to tell.
/// @param num_lengths  c: lengths between them that have to agree; one less where the scale is
/// free.
/// @return 0 or more where k <= m.
double log10_false_alarms(double k, double n, int sample_size, int num_lengths,
                          const Chance& chance);

}  // namespace gmcr::noise
