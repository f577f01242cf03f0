#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/branch_and_bound.hpp"
#include "clique/packed_graph.hpp"
#include "clique/search_budget.hpp"

namespace gmcr {

/// The largest clique known so far and the size that a clique must exceed to be of interest.
class Incumbent {
 public:
  Incumbent(std::vector<Index> clique, Index must_exceed)
      : clique_(std::move(clique)), must_exceed_(must_exceed) {}

  /// Keeps `clique` if it is larger than the present one.
  void offer(std::vector<Index> clique) {
    if (clique.size() > clique_.size()) clique_ = std::move(clique);
  }

  const std::vector<Index>& clique() const { return clique_; }
  Index size() const { return static_cast<Index>(clique_.size()); }
  Index to_beat() const { return std::max(size(), must_exceed_); }

 private:
  std::vector<Index> clique_;
  Index must_exceed_;
};

/// The search below the root: one subproblem for each vertex that a colouring leaves over.
///
/// The subproblems depend on each other through the incumbent only.
class RootSearch {
 public:
  /// @param core  core number of each vertex of `graph`; those that cannot be in a clique larger
  ///              than the incumbent are left out.
  RootSearch(RowsView graph, std::span<const Index> core, Incumbent& incumbent,
             SearchBudget& budget)
      : graph_(graph), core_(core), incumbent_(incumbent), budget_(budget) {}

  /// Searches all of `graph` unless the budget ends.
  /// @return upper bound: no clique is larger than this.
  Index run();

 private:
  std::vector<Branch> choose_branches();
  void drop_hopeless(std::vector<Word>& vertices) const;
  Index solve_subproblem(Index vertex, std::span<const Word> candidates);
  std::vector<Index> surviving_vertices(Index to_beat);

  RowsView graph_;
  std::span<const Index> core_;
  Incumbent& incumbent_;
  SearchBudget& budget_;
  BranchAndBound branch_and_bound_;
  PackedGraph neighborhood_, ordered_;
  std::vector<Word> scratch_;
};

}  // namespace gmcr
