#include "registration/range_search.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "clique/greedy.hpp"
#include "consensus/consistency_graph.hpp"
#include "registration/local_optimisation.hpp"
#include "registration/pose_from_clique.hpp"

namespace gmcr {

PoseSearch::PoseSearch(SolveContext& context, const Objective& objective, const ScaleRange& scales)
    : context_(context),
      objective_(objective),
      scales_(scales),
      arrays_(consistency_arrays(objective.correspondences(), scales.max)) {}

void PoseSearch::offer(const std::vector<Index>& clique) {
  const StageTimer timer(context_, "pose");
  if (!examined_.insert(clique).second) return;
  std::optional<Hypothesis> pose = pose_from_clique(context_, objective_, scales_, clique);
  if (!pose) return;
  if (!best_ || is_better(*pose, *best_)) {
    best_ = reach_for_more(objective_, scales_, std::move(*pose));
    max_inliers_ = std::max(max_inliers_, best_->num_inliers());
  } else {
    max_inliers_ = std::max(max_inliers_, pose->num_inliers());
  }
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales) {
  const StageTimer timer(search.context(), "graph");
  ++search.context().diagnostics().num_scale_ranges;
  RangeGraph range;
  range.graph = consistency_graph(search.arrays(), scales, search.context().options().num_threads);
  range.degeneracy = degeneracy_order(range.graph);
  return range;
}

void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts) {
  const std::vector<Index>& core = range.degeneracy.core;
  std::vector<Index> starts(core.size());
  std::iota(starts.begin(), starts.end(), Index{0});
  std::stable_sort(starts.begin(), starts.end(), [&](Index u, Index v) {
    return core[static_cast<std::size_t>(u)] > core[static_cast<std::size_t>(v)];
  });
  std::vector<bool> covered(core.size(), false);
  Index num_starts = 0;
  for (const Index start : starts) {
    const bool can_win =
        static_cast<double>(core[static_cast<std::size_t>(start)] + 1) > search.best_evidence();
    if (num_starts == max_starts || !can_win || search.context().stopped()) return;
    if (covered[static_cast<std::size_t>(start)]) continue;
    ++num_starts;
    const std::vector<Index> clique = [&] {
      const StageTimer timer(search.context(), "clique");
      return greedy_clique_by_candidates(range.graph, start, core);
    }();
    for (const Index v : clique) covered[static_cast<std::size_t>(v)] = true;
    search.offer(clique);
  }
}

Index search_maximum_clique(PoseSearch& search, const RangeGraph& range, std::uint64_t max_nodes) {
  if (range.core_bound() <= search.max_inliers()) return search.max_inliers();
  CliqueOptions clique_options;
  clique_options.max_nodes = max_nodes;
  clique_options.must_exceed = search.max_inliers();
  const CliqueResult clique = [&] {
    const StageTimer timer(search.context(), "clique");
    return search.context().max_clique(range.graph, clique_options);
  }();
  if (static_cast<Index>(clique.vertices.size()) > search.max_inliers()) {
    search.offer(clique.vertices);
  }
  return std::min(range.core_bound(), clique.upper_bound);
}

}  // namespace gmcr
