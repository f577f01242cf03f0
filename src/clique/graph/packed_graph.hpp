#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"
#include "kernels/bits/aligned_words.hpp"
#include "kernels/bits/bit_columns.hpp"

namespace gmcr::clique {

/// Induced subgraph with its own, dense numbering; its memory is reused from one to the next. Rows
/// are padded and aligned for `kernels::choose_branches`.
class PackedGraph {
 public:
  /// Becomes the subgraph of `graph` that `vertices` induce; vertex i of it is `vertices[i]`.
  /// @param vertices  distinct vertices of `graph`, in any order.
  /// @param budget    null: none.
  /// @return false where the budget ended before the edges were all there.
  /// Cost O(k min(k, n / 64)) for k vertices of n. Memory: twice the result where the vertices do
  /// not ascend.
  bool assign(RowsView graph, std::span<const Index> vertices, SearchBudget* budget = nullptr);

  /// Bytes that `assign` takes for so many vertices in any order.
  static std::size_t bytes_required(Index num_vertices) {
    return 2 * BitsetGraph::bytes_required(num_vertices);
  }

  Index num_vertices() const { return static_cast<Index>(vertices_.size()); }
  Index words_per_row() const { return words_per_row_; }
  const Word* row(Index v) const { return words_.data() + v * words_per_row_; }
  RowsView view() const { return {words_.data(), num_vertices(), words_per_row_}; }

  /// The vertex of the original graph that is number `v` here.
  Index original(Index v) const { return vertices_[v]; }

 private:
  bool copy_columns(RowsView graph, SearchBudget* budget);
  void order_columns();
  void order_block(Index row_block, Index column_block);
  bool copy_bit_by_bit(RowsView graph, SearchBudget* budget);

  Index words_per_row_ = 0;
  std::vector<Index> vertices_;
  kernels::AlignedWords words_;
  std::vector<Word> mask_;  // of the original graph: the vertices
  kernels::BitColumns columns_;
  std::vector<Word> half_ordered_;       // rows in order, columns ascending
  std::vector<std::int32_t> ascending_;  // numbers here, by ascending original
};

}  // namespace gmcr::clique
