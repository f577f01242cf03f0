#include "clique/graph/complement.hpp"

namespace gmcr::clique {
namespace {

constexpr Index kMaxMissingShare = 10;             // at most one pair of ten is no edge
constexpr Index kMaxListEntries = Index{1} << 25;  // 128 MiB

}  // namespace

ComplementLists complement_lists(RowsView graph) {
  const Index n = graph.num_vertices;
  ComplementLists lists(n);
  for (Index v = 0; v < n; ++v) {
    const Word* row = graph.row(v);
    lists[v].reserve(n - graph.degree(v));
    for (Index w = 0; w < graph.words_per_row; ++w) {
      for (Word rest = ~row[w]; rest != 0; rest &= rest - 1) {
        const Index u = w * kBitsPerWord + std::countr_zero(rest);
        if (u >= n) break;
        if (u != v) lists[v].push_back(static_cast<std::int32_t>(u));
      }
    }
  }
  return lists;
}

bool is_nearly_complete(RowsView graph) {
  const Index n = graph.num_vertices;
  const Index missing = n * (n - 1) - count_bits(graph.words, n * graph.words_per_row);
  return missing * kMaxMissingShare <= n * n && missing <= kMaxListEntries;
}

}  // namespace gmcr::clique
