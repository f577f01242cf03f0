#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/bit_rows.hpp"
#include "clique/search_budget.hpp"

namespace gmcr {

/// A vertex that a search node must branch on.
struct Branch {
  std::int32_t vertex;
  std::int32_t bound;  ///< cliques of this vertex, the earlier branches and the rest are no larger
};

/// Chooses the vertices that a search node must branch on, by colouring.
///
/// Colours the candidates with as many classes as a clique may have without beating the incumbent;
/// only what is left over needs a branch. Two repairs shrink the rest: re-colouring moves one
/// conflicting neighbour to another class (Tomita et al. 2010), and an inconsistent triple of
/// classes, in which no triangle is left, counts as two (infra-chromatic bound, San Segundo et
/// al. 2015).
class BranchSelector {
 public:
  /// Works on `graph` from now on; the choice of repairs depends on its density.
  /// @param budget  outlives the use of `graph`.
  void reset(RowsView graph, SearchBudget& budget);

  /// Appends the branches within `candidates` to `branches`, by ascending bound.
  ///
  /// The candidates that are not appended have no clique of more than `max_pruned` vertices.
  /// Once the budget is spent, all that has no class yet becomes a branch.
  /// @param seeds  as in `color_greedily`.
  /// @return whether the candidates are a clique.
  bool select(const Word* candidates, Index max_pruned, std::vector<Branch>& branches,
              std::span<const Index> seeds = {});

 private:
  void color_classes(Index max_classes, std::span<const Index> seeds);
  bool append_rest(Index max_pruned, std::vector<Branch>& branches);
  void append_all(Index bound, std::vector<Branch>& branches);
  bool repair(Index v);
  bool find_repair(Index v);

  Word* color_class(Index c) { return classes_.data() + c * words_; }
  const Word* color_class(Index c) const { return classes_.data() + c * words_; }

  RowsView graph_;
  SearchBudget* budget_ = nullptr;
  Index words_ = 0;
  Index repair_words_left_ = 0;  // word operations that the repairs of this node may still take
  bool repairs_ = false;
  Index num_classes_ = 0;
  Index num_colored_ = 0;
  std::vector<Word> uncolored_, free_, classes_;
  std::vector<char> in_triple_;  // a class that an inconsistent triple has used up
};

}  // namespace gmcr
