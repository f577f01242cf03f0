#include "search/candidate_cliques.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "clique/clique.hpp"
#include "kernels/bits/bit_row.hpp"
#include "problem/graph/consistency_graph.hpp"

namespace gmcr::search {
namespace {

/// Candidates among which a greedy clique looks for the one with most neighbours.
constexpr Index kMaxCandidates = 256;
/// Correspondences within so many bounds of a pose lead to no other: no clique starts at those of
/// the best one, and an alternative is sought without those of the poses that are known.
constexpr double kExplained = 3;
/// A clique with less than this part of the best evidence is no rival.
constexpr double kLeastPart = 0.5;

parallel::Deadline graph_deadline(const PoseSearch& search) {
  const bool is_quick = search.problem().arrays().size() <= problem::kQuickGraph;
  return is_quick ? parallel::Deadline::never() : search.run().deadline();
}

/// Removes the edges of a vertex.
void isolate(BitsetGraph& graph, Index v) {
  const auto row = graph.mutable_row(v);
  clique::for_each_bit(row.data(), graph.words_per_row(),
                       [&](Index u) { clique::clear_bit(graph.mutable_row(u).data(), v); });
  std::fill(row.begin(), row.end(), 0);
}

/// Whether a clique with vertex v may have more evidence: of v and its neighbours, and of those of
/// them that share as many neighbours with it as such a clique needs.
bool may_exceed(double evidence, const BitsetGraph& graph, const std::vector<double>& weights,
                Index v) {
  const auto weight = [&](Index u) { return weights[static_cast<std::size_t>(u)]; };
  const auto row = graph.row(v);
  const Index words = graph.words_per_row();
  double around = weight(v);
  std::vector<Index> neighbours;
  clique::for_each_bit(row.data(), words, [&](Index u) {
    around += weight(u);
    neighbours.push_back(u);
  });
  for (const Index u : neighbours) {
    if (around <= evidence) break;
    // a weight is at most 1
    const Index most = 2 + kernels::count_common_bits(row.data(), graph.row(u).data(), words);
    if (static_cast<double>(most) <= evidence) around -= weight(u);
  }
  return around > evidence;
}

std::vector<Index> by_descending(const std::vector<Index>& values) {
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return values[static_cast<std::size_t>(a)] > values[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace

std::vector<double> weights_of(const problem::Problem& problem, Measure measure,
                               const ScaleRange& scales) {
  std::vector<double> weights(static_cast<std::size_t>(problem.size()), 1.0);
  if (measure == Measure::Inliers) return weights;
  // weights grow with the scale, so those at the end of the range bound the others
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = problem.objective().weight(static_cast<Index>(i), scales.max);
  }
  return weights;
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build) {
  const StageTimer timer(search.run(), "graph");
  ++search.run().diagnostics().num_scale_ranges;
  RangeGraph range{scales, build()};
  search.problem().filter().apply(range.graph, scales, search.run().options().num_threads,
                                  graph_deadline(search));
  for (const problem::Hypothesis& known : search.left_out()) {
    for (const Index i : search.problem().objective().within(known.pose, kExplained)) {
      isolate(range.graph, i);
    }
  }
  return range;
}

RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales) {
  return build_range_graph(search, scales, [&] {
    return problem::consistency_graph(search.problem().arrays(), scales,
                                      search.run().options().num_threads, graph_deadline(search));
  });
}

void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts) {
  const Index n = range.graph.num_vertices();
  if (n > problem::kQuickGraph && search.best() && search.run().stopped()) return;
  std::vector<Index> degree;
  std::vector<Index> order;
  {
    const StageTimer timer(search.run(), "clique");
    degree = clique::degrees_of(range.graph, search.run().options().num_threads);
    order = by_descending(degree);
  }
  const std::vector<double> weights = weights_of(search.problem(), Measure::Evidence, range.scales);
  // what the best pose explains is left out: else all cliques would lead to it again
  std::vector<clique::Word> unexplained(static_cast<std::size_t>(range.graph.words_per_row()));
  std::vector<bool> covered;
  const auto leave_out_explained = [&] {
    std::fill(unexplained.begin(), unexplained.end(), ~clique::Word{0});
    for (const Index v : search.near_best(kExplained)) clique::clear_bit(unexplained.data(), v);
  };
  covered.assign(static_cast<std::size_t>(n), false);
  leave_out_explained();
  Index num_starts = 0;
  for (const Index v : order) {
    // one is looked at in any case: a pose from samples is a poor one
    if (num_starts == max_starts) return;
    if (num_starts > 0 && search.best() && search.run().stopped()) return;
    const double to_beat = search.to_beat(Measure::Evidence);
    if (static_cast<double>(degree[static_cast<std::size_t>(v)] + 1) <= to_beat) return;
    if (covered[static_cast<std::size_t>(v)] || !clique::test_bit(unexplained.data(), v)) continue;
    ++num_starts;
    if (!may_exceed(to_beat, range.graph, weights, v)) continue;
    const std::vector<Index> clique = [&] {
      const StageTimer timer(search.run(), "clique");
      return clique::greedy_clique(range.graph, v, degree, kMaxCandidates, unexplained);
    }();
    double evidence = 0;
    for (const Index u : clique) {
      covered[static_cast<std::size_t>(u)] = true;
      evidence += weights[static_cast<std::size_t>(u)];
    }
    if (evidence < kLeastPart * to_beat) continue;
    search.try_clique(clique);
    if (search.to_beat(Measure::Evidence) > to_beat) leave_out_explained();
  }
}

problem::Run::Clique find_clique(const PoseSearch& search, const RangeGraph& range, Measure measure,
                                 std::uint64_t max_nodes, int num_threads) {
  // L5: every consensus set at a scale of the range is a clique of its graph
  const double to_beat = search.to_beat(measure);
  return measure == Measure::Inliers
             ? search.run().find_max_clique(range.graph, static_cast<Index>(to_beat), max_nodes,
                                            num_threads)
             : search.run().find_max_weight_clique(
                   range.graph, weights_of(search.problem(), measure, range.scales), to_beat,
                   max_nodes, num_threads);
}

double take_clique(PoseSearch& search, Measure measure, const problem::Run::Clique& found) {
  search.run().note(found);
  if (!found.vertices.empty()) search.try_clique(found.vertices);
  if (!found.proven) {
    search.note_early_end(
        measure,
        measure == Measure::Inliers
            ? LimitHit{Limit::CliqueSearch,
                       "a clique search ended before its proof: the upper bound may be loose"}
            : LimitHit{Limit::EvidenceSearch,
                       "a search for the clique of most evidence ended before its proof: the bound "
                       "on the evidence may be loose"});
  }
  return found.upper_bound;
}

double search_clique(PoseSearch& search, const RangeGraph& range, Measure measure,
                     std::uint64_t max_nodes) {
  const problem::Run::Clique found = [&] {
    const StageTimer timer(search.run(), "clique");
    return find_clique(search, range, measure, max_nodes, search.run().options().num_threads);
  }();
  return take_clique(search, measure, found);
}

}  // namespace gmcr::search
