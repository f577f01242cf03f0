#include "clique/weighted/root_search.hpp"

#include <algorithm>

namespace gmcr::clique {

bool OrderedPart::assign(RowsView from, std::span<const std::int64_t> from_units,
                         std::span<const Index> vertices, SearchBudget& budget) {
  units.clear();
  for (const Index v : vertices) units.push_back(from_units[v]);
  return graph.assign(from, vertices, &budget);
}

std::vector<Index> best_first_order(const WeightedPeeling& peeling) {
  std::vector<Index> order;
  for_each_bit(peeling.alive().data(), static_cast<Index>(peeling.alive().size()),
               [&](Index v) { order.push_back(v); });
  const auto neighborhoods = peeling.neighborhoods();
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return neighborhoods[a] > neighborhoods[b]; });
  return order;
}

std::int64_t WeightedRootSearch::run() {
  std::vector<Word> alive(graph_.words_per_row, 0);
  for (Index v = 0; v < graph_.num_vertices; ++v) set_bit(alive.data(), v);
  candidates_.resize(graph_.words_per_row);
  std::vector<WeightedBranch> branches = choose_branches(alive);
  for (; !branches.empty() && branches.back().bound > incumbent_.to_beat(); branches.pop_back()) {
    const auto [vertex, bound] = branches.back();
    if (!budget_.spend_node(graph_.words_per_row)) return bound;
    clear_bit(alive.data(), vertex);
    const std::int64_t reachable = mask_neighbors(vertex, alive);
    const std::int64_t solved = part_.units[vertex] + solve_subproblem(vertex, reachable);
    if (budget_.spent()) {
      branches.pop_back();
      const std::int64_t rest = branches.empty() ? 0 : branches.back().bound;
      return std::max({incumbent_.to_beat(), rest, std::min(bound, solved)});
    }
  }
  return incumbent_.to_beat();
}

std::vector<WeightedBranch> WeightedRootSearch::choose_branches(const std::vector<Word>& alive) {
  std::vector<WeightedBranch> plain, split;
  coloring_.reset(graph_, part_.units, budget_);
  coloring_.select(alive.data(), incumbent_.to_beat(), Splitting::None, plain);
  if (plain.empty() || budget_.spent()) return plain;
  coloring_.select(alive.data(), incumbent_.to_beat(), Splitting::Full, split);
  const std::int64_t bound =
      split.empty() ? incumbent_.to_beat() : std::min(plain.back().bound, split.back().bound);
  std::vector<WeightedBranch>& fewer = split.size() < plain.size() ? split : plain;
  for (WeightedBranch& branch : fewer) branch.bound = std::min(branch.bound, bound);
  return std::move(fewer);
}

/// Leaves in candidates_ the neighbours of `vertex` among `alive`; returns their weight.
std::int64_t WeightedRootSearch::mask_neighbors(Index vertex, const std::vector<Word>& alive) {
  const Word* row = graph_.row(vertex);
  for (Index w = 0; w < graph_.words_per_row; ++w) candidates_[w] = alive[w] & row[w];
  std::int64_t weight = 0;
  for_each_bit(candidates_.data(), graph_.words_per_row,
               [&](Index v) { weight += part_.units[v]; });
  return weight;
}

/// Upper bound on the cliques of the candidates, or the weight that they had to exceed.
std::int64_t WeightedRootSearch::solve_subproblem(Index vertex, std::int64_t reachable) {
  const std::int64_t to_beat = incumbent_.to_beat() - part_.units[vertex];
  if (reachable <= to_beat || coloring_.covers(candidates_.data(), to_beat)) return to_beat;
  std::vector<Index> members;
  for_each_bit(candidates_.data(), graph_.words_per_row, [&](Index v) { members.push_back(v); });
  if (!neighborhood_.assign(graph_, part_.units, members, budget_)) return reachable;
  const RowsView nearby = neighborhood_.graph.view();
  const std::vector<Index> survivors = surviving_vertices(to_beat);
  if (!ordered_.assign(nearby, neighborhood_.units, survivors, budget_)) return reachable;
  const auto outcome = branch_and_bound_.search(ordered_.graph.view(), ordered_.units, to_beat,
                                                incumbent_.weights().rounding(), budget_);
  if (!outcome.clique.empty()) {
    std::vector<Index> clique{part_.graph.original(vertex)};
    for (const Index v : outcome.clique) {
      const Index here = neighborhood_.graph.original(ordered_.graph.original(v));
      clique.push_back(part_.graph.original(here));
    }
    incumbent_.offer(std::move(clique));
  }
  return outcome.upper_bound;
}

std::vector<Index> WeightedRootSearch::surviving_vertices(std::int64_t to_beat) {
  const RowsView nearby = neighborhood_.graph.view();
  peeling_.reset(nearby, neighborhood_.units, to_beat, budget_);
  peeling_.peel(to_beat);
  return best_first_order(peeling_);
}

}  // namespace gmcr::clique
