#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "consensus/pair_filter.hpp"
#include "estimation/pose_constraints.hpp"
#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "kernels/consistency_row.hpp"
#include "registration/objective.hpp"
#include "registration/solve_context.hpp"

namespace gmcr {

/// The best pose so far, and what a better one must exceed.
class PoseSearch {
 public:
  /// Keeps the references.
  PoseSearch(SolveContext& context, const Objective& objective, const PoseConstraints& constraints,
             const PairFilter& filter);

  SolveContext& context() { return context_; }
  const Objective& objective() const { return objective_; }
  const ScaleRange& scales() const { return constraints_.scales; }
  const PairFilter& filter() const { return filter_; }
  const kernels::CorrespondenceArrays& arrays() const { return arrays_; }

  /// Turns a clique into a pose and keeps it where it is the best one. Each clique is examined
  /// once.
  void offer(const std::vector<Index>& clique);

  const std::optional<Hypothesis>& best() const { return best_; }
  double best_evidence() const { return best_ ? best_->evidence : 0; }

  /// Most inliers of any pose examined, one-to-one where that is asked for; the best one may have
  /// fewer, of more distinct evidence.
  Index max_inliers() const { return max_inliers_; }

 private:
  SolveContext& context_;
  const Objective& objective_;
  const PoseConstraints& constraints_;
  const PairFilter& filter_;
  kernels::CorrespondenceArrays arrays_;
  std::optional<Hypothesis> best_;
  Index max_inliers_ = 0;
  std::set<std::vector<Index>> examined_;
};

/// The consistency graph of a range of scales, less the pairs that the filter does not admit.
struct RangeGraph {
  ScaleRange scales;
  BitsetGraph graph;
};

/// @param build  returns the graph; its time is that of the stage "graph".
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build);

/// The same from all pairs.
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales);

/// Offers greedy maximal cliques grown from the vertices of largest core number that no earlier one
/// covers, where a clique could beat the best evidence.
void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts);

/// Searches the range's graph for a clique larger than the most inliers so far and offers it.
/// @return proven upper bound on the number of inliers of poses in the range, or `max_inliers()`
///   where none can have more.
Index search_maximum_clique(PoseSearch& search, const RangeGraph& range, std::uint64_t max_nodes);

}  // namespace gmcr
