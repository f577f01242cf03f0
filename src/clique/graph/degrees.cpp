#include "clique/graph/degrees.hpp"

#include "kernels/bits/bit_row.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::clique {
namespace {

// Words from which on starting threads takes less time than reading them.
constexpr Index kMinWordsForThreads = Index{1} << 19;

}  // namespace

int threads_for(RowsView graph, int num_threads) {
  return graph.num_vertices * graph.words_per_row < kMinWordsForThreads ? 1 : num_threads;
}

std::vector<Index> degrees_of(RowsView graph, int num_threads) {
  std::vector<Index> degree(graph.num_vertices);
  parallel::parallel_for(graph.num_vertices, 4 * kBitsPerWord, threads_for(graph, num_threads),
                         [&](Index begin, Index end) {
                           for (Index v = begin; v < end; ++v) {
                             degree[v] = kernels::count_bits(graph.row(v), graph.words_per_row);
                           }
                         });
  return degree;
}

}  // namespace gmcr::clique
