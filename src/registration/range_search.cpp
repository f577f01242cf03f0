#include "registration/range_search.hpp"

#include <algorithm>
#include <utility>

#include "clique/bit_rows.hpp"
#include "clique/degeneracy.hpp"
#include "clique/greedy.hpp"
#include "consensus/consistency_graph.hpp"
#include "registration/local_optimisation.hpp"
#include "registration/pose_from_clique.hpp"

namespace gmcr {
namespace {

/// Candidates among which a greedy clique looks for the one with most neighbours.
constexpr Index kMaxCandidates = 256;

/// A vertex to grow a clique from.
struct Start {
  Index vertex = 0;
  Index core = 0;
  double evidence_bound = 0;  ///< no clique with the vertex has more evidence
};

/// All vertices, by descending core number.
std::vector<Start> list_starts(PoseSearch& search, const RangeGraph& range) {
  const StageTimer timer(search.context(), "clique");
  const std::vector<Index> core = degeneracy_order(range.graph).core;
  const Index n = range.graph.num_vertices();
  Eigen::ArrayXd weights(n);
  // weights grow with the scale, so those at the end of the range bound the others
  for (Index i = 0; i < n; ++i) weights[i] = search.objective().weight(i, range.scales.max);
  std::vector<Start> starts;
  for (Index v = 0; v < n; ++v) {
    const auto row = range.graph.row(v);
    double around = weights[v];
    for_each_bit(row.data(), static_cast<Index>(row.size()),
                 [&](Index u) { around += weights[u]; });
    const Index core_of_v = core[static_cast<std::size_t>(v)];
    starts.push_back({v, core_of_v, std::min(around, static_cast<double>(core_of_v + 1))});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.core > b.core; });
  return starts;
}

}  // namespace

PoseSearch::PoseSearch(SolveContext& context, const Objective& objective,
                       const PoseConstraints& constraints, const PairFilter& filter)
    : context_(context),
      objective_(objective),
      constraints_(constraints),
      filter_(filter),
      arrays_(consistency_arrays(objective.correspondences(), constraints.scales.max)) {}

void PoseSearch::offer(const std::vector<Index>& clique) {
  const StageTimer timer(context_, "pose");
  if (!examined_.insert(clique).second) return;
  std::optional<Hypothesis> pose = pose_from_clique(context_, objective_, constraints_, clique);
  if (!pose) return;
  // a rival is measured by what it can reach, as the best so far was
  Hypothesis reached = reach_for_more(objective_, constraints_, std::move(*pose), best_evidence());
  max_inliers_ = std::max(max_inliers_, filter_.count_one_to_one(reached.inliers));
  if (!best_ || is_better(reached, *best_)) best_ = std::move(reached);
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build) {
  const StageTimer timer(search.context(), "graph");
  ++search.context().diagnostics().num_scale_ranges;
  RangeGraph range{scales, build()};
  search.filter().apply(range.graph, scales, search.context().options().num_threads);
  return range;
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales) {
  return build_range_graph(search, scales, [&] {
    return consistency_graph(search.arrays(), scales, search.context().options().num_threads);
  });
}

void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts) {
  const std::vector<Start> starts = list_starts(search, range);
  std::vector<Index> priority(starts.size());
  for (const Start& start : starts) priority[static_cast<std::size_t>(start.vertex)] = start.core;
  std::vector<bool> covered(starts.size(), false);
  Index num_starts = 0;
  for (const Start& start : starts) {
    if (num_starts == max_starts || (search.best() && search.context().stopped())) return;
    if (covered[static_cast<std::size_t>(start.vertex)]) continue;
    if (start.evidence_bound <= search.best_evidence()) continue;
    ++num_starts;
    const std::vector<Index> clique = [&] {
      const StageTimer timer(search.context(), "clique");
      return greedy_clique_by_candidates(range.graph, start.vertex, priority, kMaxCandidates);
    }();
    for (const Index v : clique) covered[static_cast<std::size_t>(v)] = true;
    search.offer(clique);
  }
}

Index search_maximum_clique(PoseSearch& search, const RangeGraph& range, std::uint64_t max_nodes) {
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
  if (!clique.proven_optimal) {
    search.context().limit("a clique search ended before its proof: the upper bound may be loose");
  }
  return clique.upper_bound;
}

}  // namespace gmcr
