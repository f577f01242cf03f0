#include "clique/search/subproblem.hpp"

#include "clique/graph/colouring.hpp"
#include "clique/graph/degeneracy.hpp"

namespace gmcr::clique {

void Subproblem::assign(RowsView graph, Index vertex, Index bound,
                        std::span<const Word> candidates) {
  state_ = State::New;
  graph_ = graph;
  vertex_ = vertex;
  candidates_.assign(candidates.begin(), candidates.end());
  num_candidates_ = count_bits(candidates.data(), graph.words_per_row);
  bound_ = std::min(bound, 1 + num_candidates_);
}

void Subproblem::advance(Index to_beat, SearchBudget& budget) {
  if (state_ == State::New) {
    const bool is_ready = prepare(to_beat - 1, budget);
    if (!is_ready) return;
    state_ = State::Running;
  }
  branch_and_bound_.raise_to_beat(to_beat - 1);
  branch_and_bound_.run(budget);
  if (branch_and_bound_.finished()) state_ = State::Finished;
}

bool Subproblem::prepare(Index to_beat, SearchBudget& budget) {
  if (num_candidates_ <= to_beat || colors_with(graph_, candidates_, to_beat, scratch_, &budget)) {
    bound_ = std::min(bound_, 1 + to_beat);
    branch_and_bound_.clear();
    return true;
  }
  std::vector<Index> members;
  for_each_bit(candidates_.data(), graph_.words_per_row, [&](Index v) { members.push_back(v); });
  if (!neighborhood_.assign(graph_, members, &budget)) return false;
  const Degeneracy cores = degeneracy_order(neighborhood_.view(), &budget);
  std::vector<Index> survivors;
  for (auto v = cores.order.rbegin(); v != cores.order.rend(); ++v) {
    if (cores.core[*v] >= to_beat) survivors.push_back(*v);
  }
  if (!ordered_.assign(neighborhood_.view(), survivors, &budget)) return false;
  branch_and_bound_.start(ordered_, to_beat, budget);
  return true;
}

std::vector<Index> Subproblem::clique() const {
  if (state_ == State::New || branch_and_bound_.clique().empty()) return {};
  std::vector<Index> clique{vertex_};
  for (const Index v : branch_and_bound_.clique()) {
    clique.push_back(neighborhood_.original(ordered_.original(v)));
  }
  return clique;
}

Index Subproblem::upper_bound() const {
  return state_ == State::New ? bound_ : std::min(bound_, 1 + branch_and_bound_.upper_bound());
}

Index Subproblem::words_per_node() const {
  return 1 + num_candidates_ * num_candidates_ / kBitsPerWord;
}

}  // namespace gmcr::clique
