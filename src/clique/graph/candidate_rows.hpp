#pragma once

#include "clique/graph/bit_rows.hpp"
#include "kernels/bits/aligned_words.hpp"
#include "kernels/bits/branch_choice.hpp"

namespace gmcr::clique {

/// The candidates of each level of a depth-first search, one bit row a level.
class CandidateRows {
 public:
  /// All vertices of `graph` are candidates at level 0.
  void reset(RowsView graph) {
    graph_ = graph;
    words_.assign(static_cast<std::size_t>(graph.words_per_row), 0);
    set_first_bits(words_.data(), graph.num_vertices);
  }

  /// Valid until the next `descend`.
  Word* row(Index level) { return words_.data() + level * graph_.words_per_row; }

  /// Takes `vertex` from the candidates of a level; those of the next are its neighbours among the
  /// rest. @return the row of the next level. Cost O(n / 64).
  Word* descend(Index level, Index vertex) {
    Word* next = make_next(level);
    const Word* here = row(level);
    const Word* neighbours = graph_.row(vertex);
    clear_bit(row(level), vertex);
    for (Index w = 0; w < graph_.words_per_row; ++w) next[w] = here[w] & neighbours[w];
    return next;
  }

  /// The same in a graph whose rows are padded as those of `PackedGraph`.
  /// @return the number of candidates of the next level.
  Index descend_padded(Index level, Index vertex) {
    Word* next = make_next(level);
    clear_bit(row(level), vertex);
    return kernels::intersect(row(level), graph_.row(vertex), graph_.words_per_row, next);
  }

 private:
  Word* make_next(Index level) {
    const Index words = graph_.words_per_row;
    if (static_cast<Index>(words_.size()) < (level + 2) * words) {
      words_.resize(static_cast<std::size_t>(2 * (level + 2) * words));
    }
    return row(level + 1);
  }

  RowsView graph_;
  kernels::AlignedWords words_;
};

}  // namespace gmcr::clique
