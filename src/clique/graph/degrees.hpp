#pragma once

#include <vector>

#include "clique/graph/bit_rows.hpp"

namespace gmcr::clique {

/// As many threads as a pass over the graph pays for: 1 where it takes less time than to start
/// more.
int threads_for(RowsView graph, int num_threads);

/// Number of neighbours of each vertex. Cost O(n^2 / 64) on up to `num_threads` threads.
std::vector<Index> degrees_of(RowsView graph, int num_threads);

}  // namespace gmcr::clique
