#pragma once

#include <span>
#include <vector>

#include "clique/graph/packed_graph.hpp"
#include "clique/graph/search_budget.hpp"
#include "clique/search/branch_and_bound.hpp"

namespace gmcr::clique {

/// Search for a large clique that contains a given vertex of a graph: a neighbourhood with its own
/// numbers, searched in parts. Its memory is reused from one to the next.
class Subproblem {
 public:
  /// @param graph       outlives the search.
  /// @param bound       on the cliques of `vertex` and `candidates`.
  /// @param candidates  bit mask of neighbours of `vertex`.
  void assign(RowsView graph, Index vertex, Index bound, std::span<const Word> candidates);

  /// Goes on with the search until its end or until `budget` is spent.
  /// @param to_beat  size that a clique must exceed; does not fall from one call to the next.
  void advance(Index to_beat, SearchBudget& budget);

  bool finished() const { return state_ == State::Finished; }

  /// The largest clique of more than `to_beat` vertices that the last `advance` met; may be empty.
  std::vector<Index> clique() const;

  /// No clique of the vertex and its candidates is larger than this or than `to_beat`.
  Index upper_bound() const;

  /// Word operations that a node of the search takes, about.
  Index words_per_node() const;

 private:
  enum class State { New, Running, Finished };

  bool prepare(Index to_beat, SearchBudget& budget);

  State state_ = State::Finished;
  RowsView graph_;
  Index vertex_ = 0;
  Index bound_ = 0;
  Index num_candidates_ = 0;
  std::vector<Word> candidates_, scratch_;
  PackedGraph neighborhood_, ordered_;
  BranchAndBound branch_and_bound_;
};

}  // namespace gmcr::clique
