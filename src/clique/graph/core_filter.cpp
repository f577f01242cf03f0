#include "clique/graph/core_filter.hpp"

#include "clique/graph/degrees.hpp"
#include "kernels/bits/bit_row.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::clique {
namespace {

constexpr Index kMaxPasses = 16;
constexpr Index kMinDroppedShare = 32;  // a pass goes on to the next if it drops one vertex of 32

}  // namespace

std::vector<Word> drop_small_degrees(RowsView graph, std::span<const Index> degree, Index size,
                                     int num_threads, SearchBudget& budget) {
  const Index words = graph.words_per_row;
  std::vector<Word> alive(words, 0), next(words, 0);
  for (Index v = 0; v < graph.num_vertices; ++v) {
    if (degree[v] >= size) set_bit(alive.data(), v);
  }
  Index num_alive = count_bits(alive.data(), words), num_dropped = graph.num_vertices - num_alive;
  for (Index pass = 0; pass < kMaxPasses && num_alive > 0; ++pass) {
    if (num_dropped * kMinDroppedShare < num_alive) break;
    if (!budget.spend_work(num_alive * words)) break;
    // a chunk writes one word of `next`
    parallel::parallel_for(
        graph.num_vertices, kBitsPerWord, threads_for(graph, num_threads), [&](Index begin, Index) {
          Word kept = 0;
          for (Word rest = alive[begin / kBitsPerWord]; rest != 0; rest &= rest - 1) {
            const Word* row = graph.row(begin + std::countr_zero(rest));
            const bool stays = kernels::count_common_bits(row, alive.data(), words) >= size;
            kept |= stays ? rest & -rest : 0;
          }
          next[begin / kBitsPerWord] = kept;
        });
    alive.swap(next);
    const Index num_left = count_bits(alive.data(), words);
    num_dropped = num_alive - num_left;
    num_alive = num_left;
  }
  return alive;
}

}  // namespace gmcr::clique
