#include "problem/consistency_graph.hpp"

#include <limits>

#include "kernels/consistency_tiles.hpp"
#include "problem/symmetric_blocks.hpp"

namespace gmcr::problem {

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
                              int num_threads, const parallel::Deadline& deadline) {
  BitsetGraph graph(arrays.size());
  const kernels::ConsistencyTiles tiles(arrays, scales.min, scales.max);
  write_symmetric_blocks(graph, num_threads, deadline,
                         [&](Index row, Index column) { return tiles.tile(row, column); });
  return graph;
}

}  // namespace gmcr::problem
