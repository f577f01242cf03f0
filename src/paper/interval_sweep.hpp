#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::paper {

/// A point that most of the intervals contain, and which ones.
struct DeepestPoint {
  double lower = 0, upper = 0;  ///< all points of [lower, upper] are that deep
  std::vector<Index> members;   ///< ascending; their number is the depth
};

/// Point that most of the closed intervals [lower_k, upper_k] contain.
///
/// L2: intervals on a line that overlap pairwise share a point (Helly), so this is the maximum
/// clique of the paper's scale consensus graph, Eq. (11), without the graph.
/// @param lower, upper  K values each, infinities allowed; an interval with lower > upper is empty.
/// Ties go to the smallest point. Cost O(K log K).
DeepestPoint deepest_point(const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper);

}  // namespace gmcr::paper
