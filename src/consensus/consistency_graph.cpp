#include "consensus/consistency_graph.hpp"

#include <limits>

#include "consensus/mirror.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

constexpr Index kBlock = BitsetGraph::kBitsPerWord;
constexpr Index kSmall = 512;  // starting threads would take longer than the rows

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
  const int threads = arrays.size() < kSmall ? 1 : num_threads;
  // the words from the diagonal on; the others mirror them
  parallel_for(graph.num_vertices(), kBlock, threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      kernels::consistency_row(arrays, i, scales.min, scales.max, graph.mutable_row(i),
                               begin / kBlock);
    }
  });
  mirror_upper_blocks(graph, threads);
  return graph;
}

}  // namespace gmcr
