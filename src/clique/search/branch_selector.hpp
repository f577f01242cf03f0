#pragma once

#include <span>
#include <vector>

#include "clique/graph/packed_graph.hpp"
#include "clique/graph/search_budget.hpp"
#include "kernels/bits/branch_choice.hpp"

namespace gmcr::clique {

using kernels::Branch;

/// Chooses the vertices that a search node must branch on (`kernels::choose_branches`); holds the
/// memory for that.
///
/// Colours the candidates with as many classes as a clique may have without beating the incumbent;
/// only what is left over, and cannot be repaired, needs a branch.
class BranchSelector {
 public:
  /// Works on `graph` from now on, which outlives that; whether it repairs depends on the density.
  void reset(const PackedGraph& graph);

  /// Appends the branches within `candidates` (padded, aligned) to `branches`, by ascending bound.
  ///
  /// The candidates that are not appended have no clique of more than `max_pruned` vertices.
  /// Once the budget is spent, all that has no class yet becomes a branch.
  /// @param seeds  as in `colour_greedily`.
  /// @return whether the candidates are a clique.
  bool select(const Word* candidates, Index max_pruned, SearchBudget& budget,
              std::vector<Branch>& branches, std::span<const Index> seeds = {});

 private:
  RowsView graph_;
  bool repairs_ = false;
  kernels::BranchScratch scratch_;
};

}  // namespace gmcr::clique
