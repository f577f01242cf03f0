#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/graph/packed_graph.hpp"
#include "clique/graph/search_budget.hpp"
#include "clique/weighted/branch_and_bound.hpp"
#include "clique/weighted/colouring.hpp"
#include "clique/weighted/incumbent.hpp"
#include "clique/weighted/peeling.hpp"

namespace gmcr::clique {

/// A part of a graph that a search can take on: renumbered so that the best vertices come first.
struct OrderedPart {
  PackedGraph graph;
  std::vector<std::int64_t> units;  ///< weights of its vertices

  /// Becomes the part of `from` that `vertices` induce, in that order.
  /// @return false where the budget ended before.
  bool assign(RowsView from, std::span<const std::int64_t> from_units,
              std::span<const Index> vertices, SearchBudget& budget);
};

/// The vertices left in the order that searches and colourings prefer: heaviest neighbourhood
/// first.
std::vector<Index> best_first_order(const WeightedPeeling& peeling);

/// The search below the root: one subproblem for each vertex that a weighted colouring leaves over.
class WeightedRootSearch {
 public:
  /// @param part       vertices of positive weight, best first; outlives this object.
  /// @param incumbent  in the numbers of the graph that `part` is of; no vertex alone beats it.
  WeightedRootSearch(const OrderedPart& part, WeightedIncumbent& incumbent, SearchBudget& budget)
      : part_(part), graph_(part.graph.view()), incumbent_(incumbent), budget_(budget) {}

  /// Searches all of the graph unless the budget ends.
  /// @return units: no clique is heavier than this.
  std::int64_t run();

 private:
  std::vector<WeightedBranch> choose_branches(const std::vector<Word>& alive);
  std::int64_t solve_subproblem(Index vertex, std::int64_t reachable);
  std::vector<Index> surviving_vertices(std::int64_t to_beat);
  std::int64_t mask_neighbors(Index vertex, const std::vector<Word>& alive);

  const OrderedPart& part_;
  RowsView graph_;
  WeightedIncumbent& incumbent_;
  SearchBudget& budget_;
  WeightedColoring coloring_;
  WeightedBranchAndBound branch_and_bound_;
  WeightedPeeling peeling_;
  std::vector<Word> candidates_;
  OrderedPart neighborhood_, ordered_;
};

}  // namespace gmcr::clique
