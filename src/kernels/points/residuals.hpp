#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Squared residuals |b_i - (s R a_i + t)|^2, by the instruction set of this machine.
/// @param source, target  N x 3, metres.
/// @return N values, square metres. The same bits as the reference on every instruction set.
Eigen::ArrayXd squared_residuals(const Similarity& target_from_source,
                                 const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target);

/// The same, one correspondence after the other: the specification.
Eigen::ArrayXd squared_residuals_reference(const Similarity& target_from_source,
                                           const Eigen::MatrixX3d& source,
                                           const Eigen::MatrixX3d& target);

/// Correspondences that agree with a pose, and how closely.
struct Consensus {
  std::vector<Index> indices;             ///< ascending
  std::vector<double> squared_residuals;  ///< one for each of them, square metres
};

/// Correspondences with squared_residuals()[i] <= factor * squared_bounds[i], in one pass: no array
/// of N values is written. A residual or bound that is not a number does not agree.
/// @param source, target  N x 3, metres.
/// @param squared_bounds  N values, square metres.
Consensus consensus(const Similarity& target_from_source, const Eigen::MatrixX3d& source,
                    const Eigen::MatrixX3d& target, const Eigen::ArrayXd& squared_bounds,
                    double factor = 1);

}  // namespace gmcr::kernels
