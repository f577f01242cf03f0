#include "clique/search/branch_and_bound.hpp"

namespace gmcr::clique {

void BranchAndBound::start(const PackedGraph& graph, Index to_beat, SearchBudget& budget) {
  clear();
  graph_ = graph.view();
  selector_.reset(graph);
  best_size_ = std::max<Index>(0, to_beat);
  candidates_.reset(graph_);
  enter_level(graph_.num_vertices, budget);
}

void BranchAndBound::clear() {
  best_.clear();
  chosen_.clear();
  branches_.clear();
  first_branch_.clear();
  level_bound_.clear();
}

void BranchAndBound::run(SearchBudget& budget) {
  while (!finished()) {
    if (branches_.size() == first_branch_.back() || branch_bound() <= best_size_) {
      leave_level();
    } else if (budget.spend_node(words_per_node())) {
      visit_next_branch(budget);
    } else {
      return;
    }
  }
}

void BranchAndBound::raise_to_beat(Index size) {
  if (size <= best_size_) return;
  best_size_ = size;
  best_.clear();
}

void BranchAndBound::enter_level(Index bound, SearchBudget& budget) {
  const Index level = static_cast<Index>(first_branch_.size());
  first_branch_.push_back(branches_.size());
  level_bound_.push_back(bound);
  const bool is_clique =
      selector_.select(candidates_.row(level), best_size_ - level, budget, branches_);
  if (is_clique) {
    // The candidates complete the clique at once; no branch can do better.
    branches_.resize(first_branch_.back());
    record_clique(candidates_.row(level));
  }
}

void BranchAndBound::leave_level() {
  branches_.resize(first_branch_.back());
  first_branch_.pop_back();
  level_bound_.pop_back();
  if (!chosen_.empty()) chosen_.pop_back();
}

void BranchAndBound::visit_next_branch(SearchBudget& budget) {
  const Index level = static_cast<Index>(first_branch_.size()) - 1;
  const auto [v, bound] = branches_.back();
  branches_.pop_back();
  const Index num_candidates = candidates_.descend_padded(level, v);
  if (level + 1 + num_candidates <= best_size_) return;
  chosen_.push_back(v);
  enter_level(std::min<Index>(bound - 1, num_candidates), budget);
}

void BranchAndBound::record_clique(const Word* rest) {
  const Index size = static_cast<Index>(chosen_.size()) + count_bits(rest, graph_.words_per_row);
  if (size <= best_size_) return;
  best_size_ = size;
  best_ = chosen_;
  for_each_bit(rest, graph_.words_per_row, [&](Index v) { best_.push_back(v); });
}

Index BranchAndBound::branch_bound() const {
  return static_cast<Index>(chosen_.size()) + branches_.back().bound;
}

Index BranchAndBound::upper_bound() const {
  Index bound = best_size_;
  for (std::size_t level = 0; level < first_branch_.size(); ++level) {
    const std::size_t end =
        level + 1 < first_branch_.size() ? first_branch_[level + 1] : branches_.size();
    // The last branch of a level has its largest bound.
    if (end > first_branch_[level]) {
      const Index level_bound = std::min<Index>(level_bound_[level], branches_[end - 1].bound);
      bound = std::max(bound, static_cast<Index>(level) + level_bound);
    }
  }
  return bound;
}

}  // namespace gmcr::clique
