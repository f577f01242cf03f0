#pragma once

#include <optional>

#include "problem/problem.hpp"
#include "search/sampled_start.hpp"
#include "search/scales/scale_branch_and_bound.hpp"

namespace gmcr::search {

/// A search for the best pose over all scales of the problem, and what a proof goes on from: the
/// poses met, the graphs and the bounds.
///
/// Known scale: candidate cliques of the one consistency graph, by number, around the best pose and
/// away from it, by evidence (L7). Unknown scale: bins of scales, each bounded by how many others
/// each correspondence agrees with in it (L5); candidate cliques in the bins of most evidence, then
/// branch and bound over the scale. Where the time may end before all that, a pose from samples
/// comes first.
class BestPoseSearch {
 public:
  /// Searches. Keeps the references.
  BestPoseSearch(const problem::Problem& problem, problem::Run& run,
                 std::vector<problem::Hypothesis> left_out = {});
  BestPoseSearch(const BestPoseSearch&) = delete;
  BestPoseSearch& operator=(const BestPoseSearch&) = delete;

  PoseSearch& poses() { return poses_; }

  /// Proven upper bounds; a proof may lower them.
  PerMeasure& bounds() { return bounds_; }

  /// Whether the search ended before it had a graph: samples decided it, or a limit.
  bool has_no_graphs() const { return !graph_ && !scales_; }

  /// The graph of a known scale; null where it is unknown.
  const RangeGraph* graph() const { return graph_ ? &*graph_ : nullptr; }

  /// Where the scale is unknown.
  ScaleBranchAndBound& scales() { return *scales_; }

  /// The best pose, if any, and the bounds; tells the diagnostics why these may be loose.
  problem::Found found();

 private:
  /// @return whether there is no need to search.
  bool start_from_samples(const SamplingEffort& effort);
  void search_known_scale();
  void search_scales();

  PoseSearch poses_;
  PerMeasure bounds_;
  std::optional<RangeGraph> graph_;
  std::optional<VotedBins> voted_;
  std::optional<ScaleBranchAndBound> scales_;
};

/// Further poses, each the best one of what the earlier ones do not hold, until there are
/// `Options::num_hypotheses`.
/// @param best  the best one, whose search is done.
void add_alternatives(const problem::Problem& problem, problem::Run& run,
                      const problem::Hypothesis& best, problem::Found& found);

}  // namespace gmcr::search
