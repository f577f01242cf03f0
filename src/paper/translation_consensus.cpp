#include "paper/translation_consensus.hpp"

#include "kernels/consistency_row.hpp"
#include "problem/graph_rows.hpp"

namespace gmcr::paper {

BitsetGraph translation_graph(const PointsRef& measurements, const Eigen::ArrayXd& bounds,
                              int num_threads, const parallel::Deadline& deadline) {
  // the consistency test of points that all come from one source point: | |bbar| - 0 | <= eps_k
  const kernels::CorrespondenceArrays arrays{Eigen::MatrixX3d::Zero(measurements.cols(), 3),
                                             measurements.transpose(), bounds};
  return problem::graph_from_rows(
      measurements.cols(), num_threads, deadline,
      [&](Index i, auto row) { kernels::consistency_row(arrays, i, 1, 1, row); });
}

}  // namespace gmcr::paper
