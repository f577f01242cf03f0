#pragma once

#include "clique/search/root_search.hpp"

namespace gmcr::clique {

/// Search of a nearly complete graph: reductions on the complement, then its components one by one.
class ComplementSearch {
 public:
  ComplementSearch(RowsView graph, Incumbent& incumbent, SearchBudget& budget, int num_threads)
      : graph_(graph), incumbent_(incumbent), budget_(budget), num_threads_(num_threads) {}

  /// Searches all of `graph` unless the budget ends.
  /// @return upper bound: no clique is larger than this or the size that the incumbent must beat,
  ///   whichever is more.
  Index run();

 private:
  /// A component of the complement, its vertices by descending core number.
  struct Part {
    PackedGraph graph;
    std::vector<Index> core;
    std::vector<Index> clique;  // the best known, as numbers of `graph`
    Index bound = 0;            // on the cliques of `graph`
  };

  Part prepare(const std::vector<Index>& vertices, const std::vector<char>& is_known);
  void bound_by_colors(Part& part);
  void search(Part& part, Index must_exceed);

  RowsView graph_;
  Incumbent& incumbent_;
  SearchBudget& budget_;
  int num_threads_;
};

}  // namespace gmcr::clique
