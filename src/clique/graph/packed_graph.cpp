#include "clique/graph/packed_graph.hpp"

#include <algorithm>
#include <numeric>

#include "kernels/bits/bit_block.hpp"
#include "kernels/bits/branch_choice.hpp"

namespace gmcr::clique {

bool PackedGraph::assign(RowsView graph, std::span<const Index> vertices, SearchBudget* budget) {
  vertices_.assign(vertices.begin(), vertices.end());
  words_per_row_ = kernels::padded_words(num_vertices());
  words_.assign(static_cast<std::size_t>(num_vertices() * words_per_row_), 0);
  return graph.words_per_row <= num_vertices() ? copy_columns(graph, budget)
                                               : copy_bit_by_bit(graph, budget);
}

/// Takes the rows in the order wanted and their columns in ascending order. Since the graph is
/// symmetric, the transpose of that, with its rows put in order, has both in order.
bool PackedGraph::copy_columns(RowsView graph, SearchBudget* budget) {
  mask_.assign(graph.words_per_row, 0);
  for (const Index v : vertices_) set_bit(mask_.data(), v);
  columns_.reset(mask_.data(), graph.words_per_row);
  const bool ascending = std::is_sorted(vertices_.begin(), vertices_.end());
  if (!ascending) half_ordered_.assign(words_.size(), 0);
  Word* rows = ascending ? words_.data() : half_ordered_.data();
  for (Index i = 0; i < num_vertices(); ++i) {
    if (budget && !budget->spend_work(graph.words_per_row)) return false;
    columns_.copy(graph.row(vertices_[i]), rows + i * words_per_row_);
  }
  if (!ascending) order_columns();
  return true;
}

void PackedGraph::order_columns() {
  constexpr Index kSide = 8;  // blocks whose words fill a cache line of each of their rows
  const Index n = num_vertices(), num_blocks = words_for_bits(n);
  ascending_.resize(n);
  std::iota(ascending_.begin(), ascending_.end(), 0);
  std::sort(ascending_.begin(), ascending_.end(),
            [&](std::int32_t a, std::int32_t b) { return vertices_[a] < vertices_[b]; });
  for (Index row = 0; row < num_blocks; row += kSide) {
    for (Index column = 0; column < num_blocks; column += kSide) {
      const Index row_end = std::min(row + kSide, num_blocks);
      const Index column_end = std::min(column + kSide, num_blocks);
      for (Index r = row; r < row_end; ++r) {
        for (Index c = column; c < column_end; ++c) order_block(r, c);
      }
    }
  }
}

/// Turns rows in order with columns ascending into ascending columns of rows in order.
void PackedGraph::order_block(Index row_block, Index column_block) {
  const Index n = num_vertices();
  const Index row = row_block * kBitsPerWord, num_rows = std::min(kBitsPerWord, n - row);
  const Index column = column_block * kBitsPerWord,
              num_columns = std::min(kBitsPerWord, n - column);
  kernels::BitBlock block{};
  for (Index r = 0; r < num_rows; ++r) {
    block[r] = half_ordered_[(row + r) * words_per_row_ + column_block];
  }
  kernels::transpose(block);
  for (Index c = 0; c < num_columns; ++c) {
    words_[ascending_[column + c] * words_per_row_ + row_block] = block[c];
  }
}

bool PackedGraph::copy_bit_by_bit(RowsView graph, SearchBudget* budget) {
  const Index n = num_vertices();
  for (Index i = 0; i < n; ++i) {
    if (budget && !budget->spend_work(n)) return false;
    const Word* from = graph.row(vertices_[i]);
    Word* to = words_.data() + i * words_per_row_;
    for (Index j = 0; j < n; ++j) {
      to[j / kBitsPerWord] |= static_cast<Word>(test_bit(from, vertices_[j])) << (j % kBitsPerWord);
    }
  }
  return true;
}

}  // namespace gmcr::clique
