#include "paper/interval_sweep.hpp"

#include <algorithm>

namespace gmcr::paper {
namespace {

std::vector<double> sorted_ends(const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper,
                                const Eigen::ArrayXd& ends) {
  std::vector<double> sorted;
  sorted.reserve(static_cast<std::size_t>(ends.size()));
  for (Index k = 0; k < ends.size(); ++k) {
    if (lower[k] <= upper[k]) sorted.push_back(ends[k]);
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

DeepestPoint deepest_point(const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper) {
  const std::vector<double> starts = sorted_ends(lower, upper, lower);
  const std::vector<double> ends = sorted_ends(lower, upper, upper);
  DeepestPoint deepest;
  std::size_t best_depth = 0;
  // after the i-th start, the intervals that have begun less those that ended before it are open
  for (std::size_t i = 0, ended = 0; i < starts.size(); ++i) {
    while (ends[ended] < starts[i]) ++ended;
    if (i + 1 - ended > best_depth) {
      best_depth = i + 1 - ended;
      deepest.lower = starts[i];
      deepest.upper = ends[ended];
    }
  }
  // Eq. (11), L2: intervals around one point overlap pairwise: the maximum clique
  for (Index k = 0; k < lower.size(); ++k) {
    if (lower[k] <= deepest.lower && deepest.upper <= upper[k] && best_depth > 0) {
      deepest.members.push_back(k);
    }
  }
  return deepest;
}

}  // namespace gmcr::paper
