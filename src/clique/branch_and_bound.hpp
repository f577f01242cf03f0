#pragma once

#include <vector>

#include "clique/branch_selector.hpp"
#include "clique/candidate_rows.hpp"
#include "clique/search_budget.hpp"

namespace gmcr {

/// Exact search for a clique larger than a known one, in a graph small enough for a bit row per
/// level (Tomita and Seki 2003; BBMC of San Segundo et al. 2011).
///
/// Memory is reused from one search to the next; levels are no recursion, so that a clique of
/// any size fits the stack.
class BranchAndBound {
 public:
  struct Outcome {
    std::vector<Index> clique;  ///< the largest with more than `to_beat` vertices; empty: none met
    Index upper_bound = 0;      ///< no clique is larger than this or `to_beat`, whichever is more
  };

  /// Searches `graph`, whose vertices come best first: those of high core number have low numbers.
  /// Ends early when `budget` is spent; the bound is then what is left to prove.
  Outcome search(RowsView graph, Index to_beat, SearchBudget& budget);

 private:
  void enter_level(Index bound);
  void leave_level();
  void visit_next_branch();
  void record_clique(const Word* rest);
  Index branch_bound() const;
  Index unfinished_bound() const;
  Index words_per_node() const { return graph_.num_vertices * graph_.words_per_row; }

  RowsView graph_;
  BranchSelector selector_;
  Index best_size_ = 0;  // of the clique to beat
  std::vector<Index> best_;
  std::vector<Index> chosen_;  // the vertex that leads from each level to the next
  CandidateRows candidates_;
  std::vector<Branch> branches_;           // of all levels, the deepest last
  std::vector<std::size_t> first_branch_;  // one a level
  std::vector<Index> level_bound_;         // on the cliques among the candidates of each level
};

}  // namespace gmcr
