#include "consensus/translation_graph.hpp"

#include "consensus/graph_rows.hpp"
#include "kernels/consistency_row.hpp"

namespace gmcr {

BitsetGraph translation_graph(const PointsRef& measurements, const Eigen::ArrayXd& bounds,
                              int num_threads, const Deadline& deadline) {
  // the consistency test of points that all come from one source point: | |bbar| - 0 | <= eps_k
  const kernels::CorrespondenceArrays arrays{Eigen::MatrixX3d::Zero(measurements.cols(), 3),
                                             measurements.transpose(), bounds};
  return graph_from_rows(measurements.cols(), num_threads, deadline, [&](Index i, auto row) {
    kernels::consistency_row(arrays, i, 1, 1, row);
  });
}

}  // namespace gmcr
