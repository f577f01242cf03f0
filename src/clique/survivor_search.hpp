#pragma once

#include <span>
#include <vector>

#include "clique/graph/degeneracy.hpp"
#include "clique/search/root_search.hpp"

namespace gmcr::clique {

/// Greedy cliques from the first few of `starts` that no clique so far contains, until one reaches
/// `upper_bound` or the budget ends.
void grow_cliques(RowsView graph, std::span<const Index> starts, std::span<const Index> priority,
                  Incumbent& incumbent, SearchBudget& budget, Index upper_bound);

/// What is left of `incumbent` within a subgraph, as numbers of it: a clique, if maybe a smaller
/// one, that must beat the same size.
Incumbent incumbent_within(const PackedGraph& part, Index num_vertices, const Incumbent& incumbent);

/// Vertices of a subgraph, as numbers of the graph it is part of.
std::vector<Index> originals_of(const PackedGraph& part, std::span<const Index> vertices);

/// Search of the vertices that degrees leave over: a colouring, core numbers with greedy cliques,
/// branch and bound on a renumbered copy.
class SurvivorSearch {
 public:
  /// @param max_memory  bytes for a copy of the vertices searched.
  SurvivorSearch(RowsView graph, Incumbent& incumbent, SearchBudget& budget, int num_threads,
                 std::size_t max_memory)
      : graph_(graph),
        incumbent_(incumbent),
        budget_(budget),
        num_threads_(num_threads),
        max_memory_(max_memory),
        upper_bound_(graph.num_vertices) {}

  /// Searches all of `graph` unless the budget ends.
  /// @param alive           bit mask of the vertices that can be in a better clique.
  /// @param has_only_bound  whether the size to beat is no clique that is known.
  /// @return upper bound: no clique is larger than this or the size that the incumbent must beat,
  ///   whichever is more.
  Index run(std::span<const Word> alive, bool has_only_bound);

 private:
  bool settled() { return upper_bound_ <= incumbent_.to_beat() || budget_.out_of_time(); }
  void lower_bound_to(Index bound) { upper_bound_ = std::min(upper_bound_, bound); }
  void bound_by_colors(std::span<const Word> alive);
  void search_core();
  void search_copy(const PackedGraph& packed, std::span<const Index> core);

  RowsView graph_;
  Incumbent& incumbent_;
  SearchBudget& budget_;
  int num_threads_;
  std::size_t max_memory_;
  Index upper_bound_;
  Degeneracy cores_;
};

}  // namespace gmcr::clique
