#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// Maximal clique among `candidates` and `start`, which is adjacent to all of them.
///
/// Adds candidates of highest priority until few are left, and from then on always the one that is
/// heaviest together with its neighbours among the candidates.
/// @param units       one weight a vertex.
/// @param candidates  bit mask.
/// @param priority    one value a vertex.
/// @param budget      once it is spent the clique grows no more.
/// @return the clique, `start` first. Ties go to the smallest index.
/// Deterministic. Cost O(c (k + n / 64)) for k candidates of n vertices and a clique of c.
std::vector<Index> greedy_heavy_clique(RowsView graph, std::span<const std::int64_t> units,
                                       Index start, std::span<const Word> candidates,
                                       std::span<const std::int64_t> priority,
                                       SearchBudget& budget);

}  // namespace gmcr::clique
