#pragma once

#include <vector>

#include "clique/graph/candidate_rows.hpp"
#include "clique/graph/search_budget.hpp"
#include "clique/search/branch_selector.hpp"

namespace gmcr::clique {

/// Exact search for a clique larger than a known one, in a graph small enough for a bit row per
/// level (Tomita and Seki 2003; BBMC of San Segundo et al. 2011).
///
/// It can be interrupted: `run` goes on where the last one ended. Memory is reused from one search
/// to the next; levels are no recursion, so that a clique of any size fits the stack.
class BranchAndBound {
 public:
  /// Prepares a search of `graph`, which outlives it. Its vertices come best first: those of high
  /// core number have low numbers.
  void start(const PackedGraph& graph, Index to_beat, SearchBudget& budget);

  /// Ends the search.
  void clear();

  /// Searches until the end or until `budget` is spent.
  void run(SearchBudget& budget);

  /// From now on only cliques of more than `size` vertices count.
  void raise_to_beat(Index size);

  bool finished() const { return first_branch_.empty(); }

  /// The largest with more vertices than there were to beat; empty: none met.
  const std::vector<Index>& clique() const { return best_; }

  /// No clique is larger than this or the size to beat, whichever is more.
  Index upper_bound() const;

 private:
  void enter_level(Index bound, SearchBudget& budget);
  void leave_level();
  void visit_next_branch(SearchBudget& budget);
  void record_clique(const Word* rest);
  Index branch_bound() const;
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

}  // namespace gmcr::clique
