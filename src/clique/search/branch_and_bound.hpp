#pragma once

#include <algorithm>
#include <vector>

#include "clique/search/branch_selector.hpp"
#include "clique/search/depth_first_search.hpp"

namespace gmcr::clique {

/// The number of vertices, as `DepthFirstSearch` maximises it.
class SizeMeasure {
 public:
  using Value = Index;
  using Branch = clique::Branch;

  void reset(const PackedGraph& graph) {
    words_ = graph.words_per_row();
    selector_.reset(graph);
  }

  Index value(Index) const { return 1; }
  Index sum(const Word* set) const { return count_bits(set, words_); }
  Index to_beat(Index size) const { return size; }

  Index descend(CandidateRows& candidates, Index level, Index v) const {
    return candidates.descend_padded(level, v);
  }

  bool select(const Word* candidates, Index max_pruned, SearchBudget& budget,
              std::vector<Branch>& branches) {
    return selector_.select(candidates, max_pruned, budget, branches);
  }

 private:
  Index words_ = 0;
  BranchSelector selector_;
};

/// Exact search for a clique larger than a known one.
class BranchAndBound : public DepthFirstSearch<SizeMeasure> {
 public:
  /// Prepares a search of `graph`, which outlives it. Its vertices come best first: those of high
  /// core number have low numbers.
  void start(const PackedGraph& graph, Index to_beat, SearchBudget& budget) {
    measure_.reset(graph);
    begin(graph.view(), std::max<Index>(0, to_beat), budget);
  }
};

}  // namespace gmcr::clique
