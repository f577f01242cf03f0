#pragma once

#include <cstdint>
#include <vector>

#include "clique/bit_rows.hpp"
#include "clique/search_budget.hpp"

namespace gmcr {

/// For each vertex of a nearly complete graph the vertices that it is not adjacent to, ascending.
using ComplementLists = std::vector<std::vector<std::int32_t>>;

/// Cost O(n^2 / 64) and the length of the lists.
ComplementLists complement_lists(RowsView graph);

/// Whether so few vertex pairs are no edges that the work on the complement pays.
bool is_nearly_complete(RowsView graph);

/// What is left of a nearly complete graph once its easy vertices are decided.
///
/// Some maximum clique consists of `taken` and a maximum clique of each part: vertices of
/// different parts are adjacent.
struct ComplementKernel {
  std::vector<Index> taken;               ///< ascending
  std::vector<std::vector<Index>> parts;  ///< components of the complement, ascending each
};

/// Domination on the complement: where v is adjacent to all that w is adjacent to, and not to w, w
/// can be exchanged for v in any clique, so w goes. This covers the vertices of complement degree
/// 1 and those whose complement neighbours are pairwise not adjacent; a vertex without complement
/// neighbours is taken.
/// Ends early, validly, when `budget` is spent. Deterministic.
ComplementKernel reduce_by_complement(RowsView graph, SearchBudget& budget);

}  // namespace gmcr
