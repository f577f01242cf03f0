#include "consensus/consistency_graph.hpp"

#include <algorithm>
#include <limits>

#include "kernels/bit_block.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

constexpr Index kBlock = BitsetGraph::kBitsPerWord;
constexpr Index kSmall = 512;  // starting threads would take longer than the rows

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

kernels::CorrespondenceArrays consistency_arrays(const Correspondences& correspondences,
                                                 double scale_max) {
  // a residual of the caller's coordinates is off by a few units in the last place of its terms
  const double source_size =
      max_norm(correspondences.source) + correspondences.source_origin.norm();
  const double target_size =
      max_norm(correspondences.target) + correspondences.target_origin.norm();
  const double rounding =
      16 * std::numeric_limits<double>::epsilon() * (target_size + scale_max * source_size);
  return {correspondences.source.transpose(), correspondences.target.transpose(),
          correspondences.bounds + rounding};
}

BitsetGraph consistency_graph(const kernels::CorrespondenceArrays& arrays, const ScaleRange& scales,
                              int num_threads) {
  BitsetGraph graph(arrays.size());
  const Index num_blocks = graph.words_per_row();
  const int threads = arrays.size() < kSmall ? 1 : num_threads;
  // the words from the diagonal on; the others mirror them
  parallel_for(graph.num_vertices(), kBlock, threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      kernels::consistency_row(arrays, i, scales.min, scales.max, graph.mutable_row(i),
                               begin / kBlock);
    }
  });
  parallel_for(num_blocks, 1, threads, [&](Index block, Index) {
    for (Index column = 0; column < block; ++column) mirror_block(graph, column, block);
  });
  return graph;
}

}  // namespace gmcr
