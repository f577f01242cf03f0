#include "consensus/mirror.hpp"

#include <algorithm>

#include "kernels/bit_block.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

constexpr Index kBlock = BitsetGraph::kBitsPerWord;

/// Writes word `row_block` of the rows of block `column_block`, transposed, below the diagonal.
void mirror_block(BitsetGraph& graph, Index row_block, Index column_block) {
  kernels::BitBlock bits{};
  for (Index r = 0; r < kBlock; ++r) {
    bits[static_cast<std::size_t>(r)] =
        graph.row(row_block * kBlock + r)[static_cast<std::size_t>(column_block)];
  }
  kernels::transpose(bits);
  const Index num_rows = std::min(kBlock, graph.num_vertices() - column_block * kBlock);
  for (Index r = 0; r < num_rows; ++r) {
    graph.mutable_row(column_block * kBlock + r)[static_cast<std::size_t>(row_block)] =
        bits[static_cast<std::size_t>(r)];
  }
}

}  // namespace

void mirror_upper_blocks(BitsetGraph& graph, int num_threads) {
  parallel_for(graph.words_per_row(), 1, num_threads, [&](Index block, Index) {
    for (Index column = 0; column < block; ++column) mirror_block(graph, column, block);
  });
}

}  // namespace gmcr
