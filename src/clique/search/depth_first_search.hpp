#pragma once

#include <algorithm>
#include <vector>

#include "clique/graph/candidate_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// Exact search for a clique that measures more than a known one, in a graph small enough for a bit
/// row per level (Tomita and Seki 2003; BBMC of San Segundo et al. 2011).
///
/// It can be interrupted: `run` goes on where the last one ended. Memory is reused from one search
/// to the next; levels are no recursion, so that a clique of any size fits the stack.
///
/// `Measure` says what a clique is worth, in whole numbers:
///     Value, Branch                   what it is counted in; a {vertex, bound} to branch on
///     value(v), sum(set)              of a vertex, and of all vertices of a bit row
///     to_beat(value)                  what a better clique must exceed
///     descend(candidates, level, v)   goes to the next level; the sum of its candidates
///     select(set, max_pruned, budget, branches)   appends the branches of a level, by ascending
///                                     bound; whether the set is a clique
template <typename Measure>
class DepthFirstSearch {
 public:
  // NOLINTBEGIN(readability-redundant-typename): clang 14 asks for it
  using Value = typename Measure::Value;
  using Branch = typename Measure::Branch;
  // NOLINTEND(readability-redundant-typename)

  /// Ends the search.
  void clear() {
    best_.clear();
    chosen_.clear();
    branches_.clear();
    levels_.clear();
  }

  /// Searches until the end or until `budget` is spent.
  void run(SearchBudget& budget) {
    while (!finished()) {
      if (branches_.size() == levels_.back().first_branch || branch_bound() <= to_beat_) {
        leave_level();
      } else if (budget.spend_node(graph_.num_vertices * graph_.words_per_row)) {
        visit_next_branch(budget);
      } else {
        return;
      }
    }
  }

  /// From now on only cliques that measure more than `value` count.
  void raise_to_beat(Value value) {
    if (value <= to_beat_) return;
    to_beat_ = value;
    best_.clear();
  }

  bool finished() const { return levels_.empty(); }

  /// The best one above what there was to beat; empty: none met.
  const std::vector<Index>& clique() const { return best_; }

  /// No clique measures more than this or what there was to beat, whichever is more.
  Value upper_bound() const {
    Value bound = to_beat_;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const std::size_t end =
          i + 1 < levels_.size() ? levels_[i + 1].first_branch : branches_.size();
      if (end == levels_[i].first_branch) continue;
      // The last branch of a level has its largest bound.
      const Value branches_bound = levels_[i].chosen + branches_[end - 1].bound;
      bound = std::max(bound, std::min(levels_[i].bound, branches_bound));
    }
    return bound;
  }

 protected:
  /// Starts in `graph`, which outlives the search and which `measure_` knows already. Its vertices
  /// come best first.
  void begin(RowsView graph, Value to_beat, SearchBudget& budget) {
    clear();
    graph_ = graph;
    to_beat_ = to_beat;
    candidates_.reset(graph);
    enter_level(0, measure_.sum(candidates_.row(0)), budget);
  }

  Measure measure_;

 private:
  struct Level {
    std::size_t first_branch;  // its branches lie there and behind, up to those of the next level
    Value chosen;              // of the vertices chosen so far
    Value bound;               // on the cliques here, chosen vertices included
  };

  void enter_level(Value chosen, Value bound, SearchBudget& budget) {
    const Index level = static_cast<Index>(levels_.size());
    levels_.push_back({branches_.size(), chosen, bound});
    const bool is_clique =
        measure_.select(candidates_.row(level), to_beat_ - chosen, budget, branches_);
    if (is_clique) {
      // The candidates complete the clique at once; no branch can do better.
      branches_.resize(levels_.back().first_branch);
      record_clique(candidates_.row(level));
    }
  }

  void leave_level() {
    branches_.resize(levels_.back().first_branch);
    levels_.pop_back();
    if (!chosen_.empty()) chosen_.pop_back();
  }

  void visit_next_branch(SearchBudget& budget) {
    const Index level = static_cast<Index>(levels_.size()) - 1;
    const Branch branch = branches_.back();
    branches_.pop_back();
    const Value chosen = levels_.back().chosen + measure_.value(branch.vertex);
    const Value reachable = chosen + measure_.descend(candidates_, level, branch.vertex);
    if (reachable <= to_beat_) return;
    chosen_.push_back(branch.vertex);
    const Value bound = levels_.back().chosen + branch.bound;
    enter_level(chosen, std::min(bound, reachable), budget);
  }

  void record_clique(const Word* rest) {
    const Value value = levels_.back().chosen + measure_.sum(rest);
    if (value <= to_beat_) return;
    to_beat_ = measure_.to_beat(value);
    best_ = chosen_;
    for_each_bit(rest, graph_.words_per_row, [&](Index v) { best_.push_back(v); });
  }

  Value branch_bound() const { return levels_.back().chosen + branches_.back().bound; }

  RowsView graph_;
  Value to_beat_ = 0;
  std::vector<Index> best_;
  std::vector<Index> chosen_;  // the vertex that leads from each level to the next
  CandidateRows candidates_;
  std::vector<Level> levels_;
  std::vector<Branch> branches_;  // of all levels, the deepest last
};

}  // namespace gmcr::clique
