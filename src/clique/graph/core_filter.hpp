#pragma once

#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// Bit mask of the vertices that can be in a clique of more than `size`: drops those with fewer
/// than `size` neighbours among the rest, in passes over all of them, until a pass drops few.
///
/// What is left holds the core of that order, maybe with some more vertices. A few passes over rows
/// in memory order replace the bucket queue of `degeneracy_order`, which jumps once an edge.
/// @param degree  of each vertex.
/// Deterministic for any number of threads. Cost O(n^2 / 64) a pass, of which there are at most 16.
std::vector<Word> drop_small_degrees(RowsView graph, std::span<const Index> degree, Index size,
                                     int num_threads, SearchBudget& budget);

}  // namespace gmcr::clique
