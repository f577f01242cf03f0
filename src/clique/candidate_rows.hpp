#pragma once

#include <vector>

#include "clique/bit_rows.hpp"

namespace gmcr {

/// The candidates of each level of a depth-first search, one bit row a level.
class CandidateRows {
 public:
  /// All vertices of `graph` are candidates at level 0.
  void reset(RowsView graph) {
    graph_ = graph;
    words_.assign(static_cast<std::size_t>(graph.words_per_row), 0);
    for (Index v = 0; v < graph.num_vertices; ++v) set_bit(words_.data(), v);
  }

  /// Valid until the next `descend`.
  Word* row(Index level) { return words_.data() + level * graph_.words_per_row; }

  /// Takes `vertex` from the candidates of a level; those of the next are its neighbours among the
  /// rest. @return the row of the next level. Cost O(n / 64).
  Word* descend(Index level, Index vertex) {
    const Index words = graph_.words_per_row;
    if (static_cast<Index>(words_.size()) < (level + 2) * words) {
      words_.resize(static_cast<std::size_t>(2 * (level + 2) * words));
    }
    Word* here = row(level);
    Word* next = row(level + 1);
    const Word* neighbors = graph_.row(vertex);
    clear_bit(here, vertex);
    for (Index w = 0; w < words; ++w) next[w] = here[w] & neighbors[w];
    return next;
  }

 private:
  RowsView graph_;
  std::vector<Word> words_;
};

}  // namespace gmcr
