#include "clique/branch_and_bound.hpp"

namespace gmcr {

BranchAndBound::Outcome BranchAndBound::search(RowsView graph, Index to_beat,
                                               SearchBudget& budget) {
  graph_ = graph;
  selector_.reset(graph, budget);
  best_size_ = std::max<Index>(0, to_beat);
  best_.clear();
  chosen_.clear();
  branches_.clear();
  first_branch_.clear();
  level_bound_.clear();
  candidates_.reset(graph);

  enter_level(graph.num_vertices);
  Index left_over = 0;
  while (!first_branch_.empty()) {
    if (branches_.size() == first_branch_.back() || branch_bound() <= best_size_) {
      leave_level();
    } else if (budget.spend_node(words_per_node())) {
      visit_next_branch();
    } else {
      left_over = unfinished_bound();
      break;
    }
  }
  return {best_, std::max(best_size_, left_over)};
}

void BranchAndBound::enter_level(Index bound) {
  const Index level = static_cast<Index>(first_branch_.size());
  first_branch_.push_back(branches_.size());
  level_bound_.push_back(bound);
  const bool is_clique = selector_.select(candidates_.row(level), best_size_ - level, branches_);
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

void BranchAndBound::visit_next_branch() {
  const Index level = static_cast<Index>(first_branch_.size()) - 1;
  const auto [v, bound] = branches_.back();
  branches_.pop_back();
  const Index num_candidates = count_bits(candidates_.descend(level, v), graph_.words_per_row);
  if (level + 1 + num_candidates <= best_size_) return;
  chosen_.push_back(v);
  enter_level(std::min<Index>(bound - 1, num_candidates));
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

Index BranchAndBound::unfinished_bound() const {
  Index bound = 0;
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

}  // namespace gmcr
