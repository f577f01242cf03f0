#include "clique/root_search.hpp"

#include "clique/coloring.hpp"
#include "clique/degeneracy.hpp"

namespace gmcr {

Index RootSearch::run() {
  const std::vector<Branch> branches = choose_branches();
  std::vector<Word> alive(graph_.words_per_row, 0), candidates(graph_.words_per_row);
  for (Index v = 0; v < graph_.num_vertices; ++v) set_bit(alive.data(), v);
  drop_hopeless(alive);
  Index known_size = incumbent_.to_beat();

  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    if (branch->bound <= incumbent_.to_beat()) break;  // bounds ascend: so are all before
    if (incumbent_.to_beat() > known_size) {
      known_size = incumbent_.to_beat();
      drop_hopeless(alive);
    }
    if (!test_bit(alive.data(), branch->vertex)) continue;
    if (!budget_.spend_node(graph_.words_per_row)) return branch->bound;
    clear_bit(alive.data(), branch->vertex);
    const Word* row = graph_.row(branch->vertex);
    for (Index w = 0; w < graph_.words_per_row; ++w) candidates[w] = alive[w] & row[w];
    const Index bound = 1 + solve_subproblem(branch->vertex, candidates);
    if (budget_.spent()) {
      const Index rest = branch + 1 == branches.rend() ? 0 : (branch + 1)->bound;
      return std::max({incumbent_.to_beat(), rest, std::min<Index>(branch->bound, bound)});
    }
  }
  return incumbent_.to_beat();
}

std::vector<Branch> RootSearch::choose_branches() {
  std::vector<Word> alive(graph_.words_per_row, 0);
  for (Index v = 0; v < graph_.num_vertices; ++v) set_bit(alive.data(), v);
  drop_hopeless(alive);
  BranchSelector selector;
  selector.reset(graph_, budget_);
  std::vector<Branch> seeded, plain;
  selector.select(alive.data(), incumbent_.to_beat(), seeded, incumbent_.clique());
  if (seeded.empty() || budget_.spent()) return seeded;
  selector.select(alive.data(), incumbent_.to_beat(), plain);
  return plain.size() < seeded.size() ? plain : seeded;
}

void RootSearch::drop_hopeless(std::vector<Word>& vertices) const {
  for (Index v = 0; v < graph_.num_vertices; ++v) {
    if (core_[v] < incumbent_.to_beat()) clear_bit(vertices.data(), v);
  }
}

Index RootSearch::solve_subproblem(Index vertex, std::span<const Word> candidates) {
  const Index to_beat = incumbent_.to_beat() - 1;
  const Index num_candidates = count_bits(candidates.data(), graph_.words_per_row);
  if (num_candidates <= to_beat || colors_with(graph_, candidates, to_beat, scratch_, &budget_)) {
    return to_beat;
  }
  std::vector<Index> members;
  for_each_bit(candidates.data(), graph_.words_per_row, [&](Index v) { members.push_back(v); });
  if (!neighborhood_.assign(graph_, members, &budget_)) return num_candidates;
  const std::vector<Index> survivors = surviving_vertices(to_beat);
  if (!ordered_.assign(neighborhood_.view(), survivors, &budget_)) return num_candidates;
  const auto outcome = branch_and_bound_.search(ordered_.view(), to_beat, budget_);
  if (!outcome.clique.empty()) {
    std::vector<Index> clique{vertex};
    for (const Index v : outcome.clique) {
      clique.push_back(neighborhood_.original(ordered_.original(v)));
    }
    incumbent_.offer(std::move(clique));
  }
  return outcome.upper_bound;
}

std::vector<Index> RootSearch::surviving_vertices(Index to_beat) {
  const Degeneracy cores = degeneracy_order(neighborhood_.view(), &budget_);
  std::vector<Index> survivors;
  for (auto v = cores.order.rbegin(); v != cores.order.rend(); ++v) {
    if (cores.core[*v] >= to_beat) survivors.push_back(*v);
  }
  return survivors;
}

}  // namespace gmcr
