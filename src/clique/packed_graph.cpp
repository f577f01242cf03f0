#include "clique/packed_graph.hpp"

#include "kernels/branch_choice.hpp"

namespace gmcr {

bool PackedGraph::assign(RowsView graph, std::span<const Index> vertices, SearchBudget* budget) {
  vertices_.assign(vertices.begin(), vertices.end());
  words_per_row_ = kernels::padded_words(num_vertices());
  words_.assign(static_cast<std::size_t>(num_vertices() * words_per_row_), 0);
  return graph.words_per_row <= num_vertices() ? copy_set_bits(graph, budget)
                                               : copy_bit_by_bit(graph, budget);
}

bool PackedGraph::copy_set_bits(RowsView graph, SearchBudget* budget) {
  mask_.assign(graph.words_per_row, 0);
  number_of_.resize(graph.num_vertices);
  for (Index i = 0; i < num_vertices(); ++i) {
    set_bit(mask_.data(), vertices_[i]);
    number_of_[vertices_[i]] = static_cast<std::int32_t>(i);
  }
  for (Index i = 0; i < num_vertices(); ++i) {
    if (budget && !budget->spend_work(graph.words_per_row + num_vertices())) return false;
    const Word* from = graph.row(vertices_[i]);
    Word* to = words_.data() + i * words_per_row_;
    for (Index w = 0; w < graph.words_per_row; ++w) {
      for (Word rest = from[w] & mask_[w]; rest != 0; rest &= rest - 1) {
        set_bit(to, number_of_[w * kBitsPerWord + std::countr_zero(rest)]);
      }
    }
  }
  return true;
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

}  // namespace gmcr
