#pragma once

#include <atomic>

#include "gmcr/bitset_graph.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::problem {

/// Graph whose row v is written by write_row(v, row), which must be symmetric. Rows in parallel.
/// @return a graph without edges where the deadline passes before the last row.
template <typename WriteRow>
BitsetGraph graph_from_rows(Index num_vertices, int num_threads, const parallel::Deadline& deadline,
                            const WriteRow& write_row) {
  constexpr Index kRowsPerChunk = 64;
  BitsetGraph graph(num_vertices);
  std::atomic<bool> late = false;
  parallel::parallel_for(num_vertices, kRowsPerChunk,
                         parallel::threads_for_pairs(num_vertices, num_threads),
                         [&](Index begin, Index end) {
                           if (late || deadline.expired()) {
                             late = true;
                             return;
                           }
                           for (Index v = begin; v < end; ++v) write_row(v, graph.mutable_row(v));
                         });
  if (late) graph = BitsetGraph(num_vertices);
  return graph;
}

}  // namespace gmcr::problem
