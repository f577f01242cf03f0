#include "registration/range_search.hpp"

#include <algorithm>
#include <utility>

#include "clique/bit_rows.hpp"
#include "clique/degeneracy.hpp"
#include "clique/greedy.hpp"
#include "consensus/consistency_graph.hpp"
#include "estimation/constrained_fit.hpp"
#include "registration/local_optimisation.hpp"
#include "registration/pattern_search.hpp"
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

/// Removes the edges of a vertex.
void isolate(BitsetGraph& graph, Index v) {
  const auto row = graph.mutable_row(v);
  for_each_bit(row.data(), graph.words_per_row(),
               [&](Index u) { clear_bit(graph.mutable_row(u).data(), v); });
  std::fill(row.begin(), row.end(), 0);
}

/// All vertices, by descending core number.
std::vector<Start> list_starts(PoseSearch& search, const RangeGraph& range) {
  const StageTimer timer(search.context(), "clique");
  const std::vector<Index> core = degeneracy_order(range.graph).core;
  const Index n = range.graph.num_vertices();
  const std::vector<double> weights = search.weights(Measure::Evidence, range.scales);
  const auto weight = [&](Index v) { return weights[static_cast<std::size_t>(v)]; };
  std::vector<Start> starts;
  for (Index v = 0; v < n; ++v) {
    const auto row = range.graph.row(v);
    double around = weight(v);
    for_each_bit(row.data(), static_cast<Index>(row.size()), [&](Index u) { around += weight(u); });
    const Index core_of_v = core[static_cast<std::size_t>(v)];
    starts.push_back({v, core_of_v, std::min(around, static_cast<double>(core_of_v + 1))});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.core > b.core; });
  return starts;
}

}  // namespace

PoseSearch::PoseSearch(SolveContext& context, const Objective& objective,
                       const PoseConstraints& constraints, const PairFilter& filter,
                       std::vector<Hypothesis> found)
    : context_(context),
      objective_(objective),
      constraints_(constraints),
      filter_(filter),
      arrays_(consistency_arrays(objective.correspondences(), constraints.scales.max)),
      found_(std::move(found)) {}

void PoseSearch::offer(const std::vector<Index>& clique) {
  const StageTimer timer(context_, "pose");
  if (!examined_.insert(clique).second) return;
  std::optional<Hypothesis> pose =
      pose_from_clique(context_, objective_, constraints_, clique, rival());
  if (pose) consider(std::move(*pose));
}

void PoseSearch::offer(const Similarity& pose) {
  const StageTimer timer(context_, "pose");
  ++context_.diagnostics().num_candidates;
  const Correspondences& c = objective_.correspondences();
  Hypothesis judged = objective_.judge(pose);
  if (!constraints_.priors.empty()) {
    const auto admitted = fit_pose(c.source, c.target, c.bounds, judged.inliers, constraints_);
    if (!admitted) return;
    judged = objective_.judge(*admitted);
  }
  consider(std::move(judged));
}

Rival PoseSearch::rival() const {
  constexpr int kPatience = 5;
  return {best_ ? &*best_ : nullptr, num_in_vain_ >= kPatience};
}

void PoseSearch::consider(Hypothesis pose) {
  if (rival().is_near(pose.inliers)) ++num_in_vain_;
  if (!reached_.insert(pose.inliers).second) return;
  // a rival is measured by what it can reach, as the best so far was
  Hypothesis reached =
      reach_for_more(objective_, constraints_, std::move(pose), rival().evidence());
  constexpr double kClose = 0.9;
  if (reached.evidence > kClose * rival().evidence()) {
    reached = climb_by_motions(objective_, constraints_, std::move(reached));
  }
  for (const Hypothesis& known : found_) {
    if (shares_most(known.inliers, reached.inliers)) return;
  }
  const std::vector<Index> members = filter_.one_to_one(reached.inliers);
  max_inliers_ = std::max(max_inliers_, static_cast<double>(members.size()));
  max_evidence_ =
      std::max(max_evidence_, objective_.evidence_of(members, reached.target_from_source.scale));
  if (best_ && !is_better(reached, *best_)) return;
  best_ = std::move(reached);
  num_in_vain_ = 0;
}

void PoseSearch::explain(const UpperBounds& bounds) {
  for (const auto& [measure, sentences] : early_ends_) {
    const double bound = measure == Measure::Inliers ? bounds.inliers : bounds.evidence;
    if (!exceeds(bound, to_beat(measure))) continue;
    for (const std::string& sentence : sentences) context_.limit(sentence);
  }
}

std::vector<double> PoseSearch::weights(Measure measure, const ScaleRange& scales) const {
  std::vector<double> weights(static_cast<std::size_t>(arrays_.size()), 1.0);
  if (measure == Measure::Inliers) return weights;
  // weights grow with the scale, so those at the end of the range bound the others
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = objective_.weight(static_cast<Index>(i), scales.max);
  }
  return weights;
}

void PoseSearch::filter_graph(BitsetGraph& graph, const ScaleRange& scales) const {
  filter_.apply(graph, scales, context_.options().num_threads);
  for (const Hypothesis& known : found_) {
    for (const Index i : known.inliers) isolate(graph, i);
  }
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build) {
  const StageTimer timer(search.context(), "graph");
  ++search.context().diagnostics().num_scale_ranges;
  RangeGraph range{scales, build()};
  search.filter_graph(range.graph, scales);
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
    if (start.evidence_bound <= search.to_beat(Measure::Evidence)) continue;
    ++num_starts;
    const std::vector<Index> clique = [&] {
      const StageTimer timer(search.context(), "clique");
      return greedy_clique_by_candidates(range.graph, start.vertex, priority, kMaxCandidates);
    }();
    for (const Index v : clique) covered[static_cast<std::size_t>(v)] = true;
    search.offer(clique);
  }
}

double search_clique(PoseSearch& search, const RangeGraph& range, Measure measure,
                     std::uint64_t max_nodes) {
  const double to_beat = search.to_beat(measure);
  const auto [vertices, upper_bound, proven] = [&] {
    const StageTimer timer(search.context(), "clique");
    return measure == Measure::Inliers
               ? search.context().max_clique(range.graph, static_cast<Index>(to_beat), max_nodes)
               : search.context().max_weight_clique(
                     range.graph, search.weights(measure, range.scales), to_beat, max_nodes);
  }();
  if (!vertices.empty()) search.offer(vertices);
  if (!proven) {
    search.note_early_end(
        measure, measure == Measure::Inliers
                     ? "a clique search ended before its proof: the upper bound may be loose"
                     : "a search for the clique of most evidence ended before its proof: the bound "
                       "on the evidence may be loose");
  }
  return proven && vertices.empty() ? to_beat : upper_bound;
}

}  // namespace gmcr
