#include "clique/survivor_search.hpp"

#include "clique/graph/colouring.hpp"
#include "clique/graph/complement.hpp"
#include "clique/nearly_complete/complement_search.hpp"
#include "clique/search/greedy.hpp"

namespace gmcr::clique {
namespace {

// Starts of greedy cliques: one for 64 vertices, within these bounds.
constexpr Index kMinGreedyStarts = 4, kMaxGreedyStarts = 8;
constexpr Index kMaxVerticesToColorTwice = 1024;
// A renumbered copy of the vertices pays unless it doubles a large memory.
constexpr Index kMaxWordsOfFullCopy = Index{1} << 23;  // 64 MiB

}  // namespace

void grow_cliques(RowsView graph, std::span<const Index> starts, std::span<const Index> priority,
                  Incumbent& incumbent, SearchBudget& budget, Index upper_bound) {
  std::vector<char> covered(graph.num_vertices, 0);
  const Index max_starts = std::clamp(graph.num_vertices / 64, kMinGreedyStarts, kMaxGreedyStarts);
  Index num_starts = 0;
  for (const Index start : starts) {
    if (covered[start]) continue;
    if (upper_bound <= incumbent.to_beat() || budget.out_of_time()) return;
    if (num_starts++ == max_starts) return;
    std::vector<Index> clique = greedy_clique(graph, start, priority);
    for (const Index v : clique) covered[v] = 1;
    incumbent.offer(std::move(clique));
  }
}

Incumbent incumbent_within(const PackedGraph& part, Index num_vertices,
                           const Incumbent& incumbent) {
  std::vector<Index> number(num_vertices, -1), known;
  for (Index i = 0; i < part.num_vertices(); ++i) number[part.original(i)] = i;
  for (const Index v : incumbent.clique()) {
    if (number[v] >= 0) known.push_back(number[v]);
  }
  return {std::move(known), incumbent.to_beat()};
}

std::vector<Index> originals_of(const PackedGraph& part, std::span<const Index> vertices) {
  std::vector<Index> originals;
  for (const Index v : vertices) originals.push_back(part.original(v));
  return originals;
}

Index SurvivorSearch::run(std::span<const Word> alive, bool has_only_bound) {
  if (has_only_bound) {
    bound_by_colors(alive);
    if (settled()) return upper_bound_;
    const std::vector<Index> degree = [&] {
      std::vector<Index> degrees(graph_.num_vertices);
      for (Index v = 0; v < graph_.num_vertices; ++v) degrees[v] = graph_.degree(v);
      return degrees;
    }();
    const auto start = std::max_element(degree.begin(), degree.end()) - degree.begin();
    incumbent_.offer(greedy_clique(graph_, start, degree));
  }
  if (!settled()) bound_by_colors(alive);
  // Graphs made by a rule are often coloured best as their vertices are numbered.
  if (!settled() && graph_.num_vertices <= kMaxVerticesToColorTwice) {
    lower_bound_to(
        std::max(color_greedily(graph_, alive, {}, &budget_).num_colors, incumbent_.to_beat()));
  }
  if (!settled()) {
    cores_ = degeneracy_order(graph_, &budget_);
    lower_bound_to(cores_.degeneracy + 1);
  }
  if (!settled()) {
    const std::vector<Index> best_first(cores_.order.rbegin(), cores_.order.rend());
    grow_cliques(graph_, best_first, cores_.core, incumbent_, budget_, upper_bound_);
  }
  if (!settled()) search_core();
  return upper_bound_;
}

void SurvivorSearch::bound_by_colors(std::span<const Word> alive) {
  std::vector<Index> seeds;
  for (const Index v : incumbent_.clique()) {
    if (test_bit(alive.data(), v)) seeds.push_back(v);
  }
  lower_bound_to(
      std::max(color_greedily(graph_, alive, seeds, &budget_).num_colors, incumbent_.to_beat()));
}

/// Branch and bound on the vertices whose core number admits a better clique.
void SurvivorSearch::search_core() {
  std::vector<Index> survivors;
  for (auto v = cores_.order.rbegin(); v != cores_.order.rend(); ++v) {
    if (cores_.core[*v] >= incumbent_.to_beat()) survivors.push_back(*v);
  }
  const Index count = static_cast<Index>(survivors.size());
  const bool copies =
      PackedGraph::bytes_required(count) <= max_memory_ &&
      (count * words_for_bits(count) <= kMaxWordsOfFullCopy || 2 * count <= graph_.num_vertices);
  if (!copies) {
    lower_bound_to(RootSearch(graph_, cores_.core, incumbent_, budget_, num_threads_).run());
    return;
  }
  PackedGraph packed;
  if (!packed.assign(graph_, survivors, &budget_)) return;
  std::vector<Index> core;
  for (const Index v : survivors) core.push_back(cores_.core[v]);
  search_copy(packed, core);
}

void SurvivorSearch::search_copy(const PackedGraph& packed, std::span<const Index> core) {
  const RowsView view = packed.view();
  Incumbent inner = incumbent_within(packed, graph_.num_vertices, incumbent_);
  if (is_nearly_complete(view)) {
    lower_bound_to(ComplementSearch(view, inner, budget_, num_threads_).run());
  } else {
    lower_bound_to(RootSearch(packed, core, inner, budget_, num_threads_).run());
  }
  incumbent_.offer(originals_of(packed, inner.clique()));
}

}  // namespace gmcr::clique
