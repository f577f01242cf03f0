#include "clique/weighted/branch_and_bound.hpp"

#include <numeric>

namespace gmcr::clique {

WeightedBranchAndBound::Outcome WeightedBranchAndBound::search(RowsView graph,
                                                               std::span<const std::int64_t> units,
                                                               std::int64_t to_beat,
                                                               WeightRounding rounding,
                                                               SearchBudget& budget) {
  graph_ = graph;
  units_ = units;
  coloring_.reset(graph, units, budget);
  rounding_ = rounding;
  to_beat_ = to_beat;
  best_clique_.clear();
  chosen_.clear();
  branches_.clear();
  levels_.clear();
  candidates_.reset(graph);

  enter_level(0, std::accumulate(units.begin(), units.end(), std::int64_t{0}));
  std::int64_t left_over = 0;
  while (!levels_.empty()) {
    if (branches_.size() == levels_.back().first_branch || branch_bound() <= to_beat_) {
      leave_level();
    } else if (budget.spend_node(words_per_node())) {
      visit_next_branch();
    } else {
      left_over = unfinished_bound();
      break;
    }
  }
  return {best_clique_, std::max(to_beat_, left_over)};
}

void WeightedBranchAndBound::enter_level(std::int64_t weight, std::int64_t bound) {
  const Index level = static_cast<Index>(levels_.size());
  levels_.push_back({branches_.size(), weight, bound});
  const bool is_clique =
      coloring_.select(candidates_.row(level), to_beat_ - weight, Splitting::Full, branches_);
  if (is_clique) {
    // The candidates complete the clique at once; no branch can do better.
    branches_.resize(levels_.back().first_branch);
    record_clique(candidates_.row(level));
  }
}

void WeightedBranchAndBound::leave_level() {
  branches_.resize(levels_.back().first_branch);
  levels_.pop_back();
  if (!chosen_.empty()) chosen_.pop_back();
}

void WeightedBranchAndBound::visit_next_branch() {
  const Index level = static_cast<Index>(levels_.size()) - 1;
  const auto [v, branch_limit] = branches_.back();
  branches_.pop_back();
  const Word* next = candidates_.descend(level, v);
  const std::int64_t weight = levels_.back().weight + units_[v];
  std::int64_t reachable = weight;
  for_each_bit(next, graph_.words_per_row, [&](Index u) { reachable += units_[u]; });
  if (reachable <= to_beat_) return;
  chosen_.push_back(v);
  enter_level(weight, std::min(levels_.back().weight + branch_limit, reachable));
}

void WeightedBranchAndBound::record_clique(const Word* rest) {
  std::int64_t weight = levels_.back().weight;
  for_each_bit(rest, graph_.words_per_row, [&](Index v) { weight += units_[v]; });
  if (weight <= to_beat_) return;
  to_beat_ = rounding_.to_beat(weight);
  best_clique_ = chosen_;
  for_each_bit(rest, graph_.words_per_row, [&](Index v) { best_clique_.push_back(v); });
}

std::int64_t WeightedBranchAndBound::unfinished_bound() const {
  std::int64_t bound = 0;
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const std::size_t end = i + 1 < levels_.size() ? levels_[i + 1].first_branch : branches_.size();
    // The last branch of a level has its largest bound.
    if (end == levels_[i].first_branch) continue;
    const std::int64_t branches_bound = levels_[i].weight + branches_[end - 1].bound;
    bound = std::max(bound, std::min(levels_[i].bound, branches_bound));
  }
  return bound;
}

}  // namespace gmcr::clique
