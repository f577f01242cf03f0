#pragma once

#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

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

}  // namespace gmcr::clique
