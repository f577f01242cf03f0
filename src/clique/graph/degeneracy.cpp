#include "clique/graph/degeneracy.hpp"

#include <cstdint>
#include <utility>

#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {
namespace {

// Lowering a degree costs about as much as this many word operations.
constexpr Index kWordsPerEdge = 8;

/// Vertices sorted by their current degree; a degree falls by one in O(1).
class DegreeBuckets {
 public:
  explicit DegreeBuckets(RowsView graph)
      : degree_(graph.num_vertices), position_(graph.num_vertices), sorted_(graph.num_vertices) {
    begin_.assign(static_cast<std::size_t>(graph.num_vertices) + 1, 0);
    for (Index v = 0; v < graph.num_vertices; ++v) {
      degree_[v] = static_cast<std::int32_t>(graph.degree(v));
      ++begin_[degree_[v] + 1];
    }
    for (std::size_t d = 1; d < begin_.size(); ++d) begin_[d] += begin_[d - 1];
    std::vector<std::int32_t> next(begin_.begin(), begin_.end());
    for (Index v = 0; v < graph.num_vertices; ++v) {
      position_[v] = next[degree_[v]]++;
      sorted_[position_[v]] = static_cast<std::int32_t>(v);
    }
  }

  std::int32_t degree(Index v) const { return degree_[v]; }

  /// Takes out a vertex of smallest degree; `num_taken` were taken before.
  Index take_smallest(Index num_taken) {
    const Index v = sorted_[num_taken];
    // What is left starts behind v; a neighbour of v may fall one bucket below it.
    const std::int32_t rest = static_cast<std::int32_t>(num_taken) + 1;
    begin_[degree_[v]] = rest;
    if (degree_[v] > 0) begin_[degree_[v] - 1] = rest;
    return v;
  }

  /// Lowers the degree of `v`; it becomes the last of its new bucket.
  void decrease(Index v) {
    const std::int32_t front = begin_[degree_[v]]++;
    const std::int32_t other = sorted_[front];
    std::swap(sorted_[front], sorted_[position_[v]]);
    std::swap(position_[v], position_[other]);
    --degree_[v];
  }

 private:
  std::vector<std::int32_t> degree_, position_, sorted_;
  std::vector<std::int32_t> begin_;  // first position of each degree
};

}  // namespace

Degeneracy degeneracy_order(RowsView graph, SearchBudget* budget) {
  const Index n = graph.num_vertices;
  Degeneracy result;
  result.order.reserve(n);
  result.core.resize(n);
  DegreeBuckets buckets(graph);
  std::vector<Word> later(graph.words_per_row, 0);
  for (Index v = 0; v < n; ++v) set_bit(later.data(), v);

  for (Index i = 0; i < n; ++i) {
    const Index v = buckets.take_smallest(i);
    result.order.push_back(v);
    result.degeneracy = std::max<Index>(result.degeneracy, buckets.degree(v));
    // Out of budget, degrees fall no more: ascending as they are, they bound the core numbers.
    result.core[v] = result.degeneracy;
    if (budget && !budget->spend_work(graph.words_per_row + kWordsPerEdge * buckets.degree(v))) {
      continue;
    }
    clear_bit(later.data(), v);
    const Word* row = graph.row(v);
    for (Index w = 0; w < graph.words_per_row; ++w) {
      for (Word rest = row[w] & later[w]; rest != 0; rest &= rest - 1) {
        buckets.decrease(w * kBitsPerWord + std::countr_zero(rest));
      }
    }
  }
  return result;
}

}  // namespace gmcr::clique
