#include "clique/weighted/greedy.hpp"

#include "clique/graph/packed_graph.hpp"

namespace gmcr::clique {
namespace {

// More candidates than these are taken by priority: to rank them costs the square of their number.
constexpr Index kMaxCandidatesToRank = 1024;

}  // namespace

std::vector<Index> greedy_heavy_clique(RowsView graph, std::span<const std::int64_t> units,
                                       Index start, std::span<const Word> candidates,
                                       std::span<const std::int64_t> priority,
                                       SearchBudget& budget) {
  std::vector<Index> clique{start}, alive;
  for_each_bit(candidates.data(), graph.words_per_row, [&](Index v) { alive.push_back(v); });
  while (static_cast<Index>(alive.size()) > kMaxCandidatesToRank) {
    const Index best = *std::max_element(
        alive.begin(), alive.end(), [&](Index a, Index b) { return priority[a] < priority[b]; });
    clique.push_back(best);
    std::erase_if(alive, [&](Index v) { return !test_bit(graph.row(best), v); });
    if (!budget.spend_work(static_cast<Index>(alive.size()))) return clique;
  }
  PackedGraph packed;
  if (!packed.assign(graph, alive, &budget)) return clique;

  const Index n = packed.num_vertices();
  std::vector<std::int64_t> neighborhood(n);
  for (Index v = 0; v < n; ++v) {
    alive[v] = v;
    neighborhood[v] = units[packed.original(v)];
    for_each_bit(packed.row(v), packed.words_per_row(),
                 [&](Index u) { neighborhood[v] += units[packed.original(u)]; });
  }
  while (!alive.empty() && budget.spend_work(n)) {
    const Index best = *std::max_element(alive.begin(), alive.end(), [&](Index a, Index b) {
      return neighborhood[a] < neighborhood[b];
    });
    clique.push_back(packed.original(best));
    const Word* row = packed.row(best);
    const auto drop = std::stable_partition(alive.begin(), alive.end(),
                                            [&](Index v) { return v != best && test_bit(row, v); });
    for (auto v = drop; v != alive.end(); ++v) {
      const std::int64_t weight = units[packed.original(*v)];
      for_each_bit(packed.row(*v), packed.words_per_row(),
                   [&](Index u) { neighborhood[u] -= weight; });
      budget.spend_work(n);
    }
    alive.erase(drop, alive.end());
  }
  return clique;
}

}  // namespace gmcr::clique
