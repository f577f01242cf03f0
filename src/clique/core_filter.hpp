#pragma once

#include <vector>

#include "clique/bit_rows.hpp"
#include "clique/search_budget.hpp"

namespace gmcr {

/// As many threads as a pass over the graph pays for: 1 where it takes less time than to start
/// more.
int threads_for(RowsView graph, int num_threads);

/// Number of neighbours of each vertex. Cost O(n^2 / 64) on up to `num_threads` threads.
std::vector<Index> degrees_of(RowsView graph, int num_threads);

/// Bit mask of the vertices that can be in a clique of more than `size`: drops those with fewer
/// than `size` neighbours among the rest, in passes over all of them, until a pass drops few.
///
/// What is left holds the core of that order, maybe with some more vertices. A few passes over rows
/// in memory order replace the bucket queue of `degeneracy_order`, which jumps once an edge.
/// @param degree  of each vertex.
/// Deterministic for any number of threads. Cost O(n^2 / 64) a pass, of which there are at most 16.
std::vector<Word> drop_small_degrees(RowsView graph, std::span<const Index> degree, Index size,
                                     int num_threads, SearchBudget& budget);

}  // namespace gmcr
