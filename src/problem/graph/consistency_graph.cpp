#include "problem/graph/consistency_graph.hpp"

#include <limits>

#include "kernels/pairs/consistency_tiles.hpp"
#include "problem/graph/symmetric_blocks.hpp"

namespace gmcr::problem {

Eigen::ArrayXd rounding_of_residuals(const Correspondences& correspondences, double scale_max) {
  // a residual of the caller's coordinates is off by a few units in the last place of its terms
  constexpr double kUnits = 16 * std::numeric_limits<double>::epsilon();
  constexpr double kNegligible = 1e-3;
  const double source_origin = correspondences.source_origin.norm();
  const double target_origin = correspondences.target_origin.norm();
  const Index n = correspondences.size();
  const double largest = kUnits * (max_norm(correspondences.target) + target_origin +
                                   scale_max * (max_norm(correspondences.source) + source_origin));
  // bounds that are alike stay alike, which graphs are built faster of
  if (n == 0 || largest <= kNegligible * correspondences.bounds.minCoeff()) {
    return Eigen::ArrayXd::Constant(n, largest);
  }
  // a match that is far out says nothing of the others
  return kUnits * (correspondences.target.colwise().norm().transpose().array() + target_origin +
                   scale_max * (correspondences.source.colwise().norm().transpose().array() +
                                source_origin));
}

geometry::CorrespondenceArrays consistency_arrays(const Correspondences& correspondences,
                                                  double scale_max) {
  return {correspondences.source.transpose(), correspondences.target.transpose(),
          correspondences.bounds + rounding_of_residuals(correspondences, scale_max)};
}

BitsetGraph consistency_graph(const geometry::CorrespondenceArrays& arrays,
                              const ScaleRange& scales, int num_threads,
                              const parallel::Deadline& deadline) {
  BitsetGraph graph(arrays.size());
  const kernels::ConsistencyTiles tiles(arrays, scales.min, scales.max);
  write_symmetric_blocks(graph, num_threads, deadline,
                         [&](Index row, Index column) { return tiles.tile(row, column); });
  return graph;
}

}  // namespace gmcr::problem
