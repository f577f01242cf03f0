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

Index num_missing_ends(RowsView graph) {
  return graph.num_vertices * (graph.num_vertices - 1) - graph.num_edge_ends();
}

bool is_nearly_complete(RowsView graph) {
  const Index n = graph.num_vertices, missing = num_missing_ends(graph);
  return missing * kMaxMissingShare <= n * n && missing <= kMaxListEntries;
}

}  // namespace gmcr::clique
