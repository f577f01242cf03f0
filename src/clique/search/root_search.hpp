#pragma once

#include <memory>
#include <span>
#include <vector>

#include "clique/graph/search_budget.hpp"
#include "clique/search/incumbent.hpp"
#include "clique/search/subproblem.hpp"

namespace gmcr::clique {

/// The search below the root: one subproblem for each vertex that a colouring leaves over.
///
/// Some subproblems are searched at a time, on up to `num_threads` threads; they learn of each
/// other's cliques between rounds only, so that the result is the same for any number of threads.
class RootSearch {
 public:
  /// @param core  core number of each vertex of `graph`; those that cannot be in a clique larger
  ///              than the incumbent are left out.
  RootSearch(const PackedGraph& graph, std::span<const Index> core, Incumbent& incumbent,
             SearchBudget& budget, int num_threads)
      : RootSearch(graph.view(), core, incumbent, budget, num_threads) {
    packed_ = &graph;
  }

  /// The same in rows that are not padded, with weaker bounds at the root.
  RootSearch(RowsView graph, std::span<const Index> core, Incumbent& incumbent,
             SearchBudget& budget, int num_threads)
      : graph_(graph),
        core_(core),
        incumbent_(incumbent),
        budget_(budget),
        num_threads_(num_threads) {}

  /// Searches all of `graph` unless the budget ends.
  /// @return upper bound: no clique is larger than this.
  Index run();

 private:
  std::vector<Branch> choose_branches();
  std::vector<Branch> branches_by_colouring();
  kernels::AlignedWords hopeful_vertices() const;
  void drop_light(std::span<Word> vertices) const;
  bool fill(std::size_t num_active);
  void advance_all(int num_threads);
  void improve_clique();

  const PackedGraph* packed_ = nullptr;
  RowsView graph_;
  std::span<const Index> core_;
  Incumbent& incumbent_;
  SearchBudget& budget_;
  int num_threads_;
  std::vector<Branch> branches_;  // those to come, the next one last
  kernels::AlignedWords alive_;
  bool has_swapped_ = false;
  Index work_each_ = 0;   // word operations of a subproblem until the others learn of its clique
  Index known_size_ = 0;  // of the clique to beat by which `alive_` was thinned out
  std::vector<std::unique_ptr<Subproblem>> active_, idle_;
};

}  // namespace gmcr::clique
