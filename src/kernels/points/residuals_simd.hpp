#pragma once

#include <cstdint>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Points and the map x -> matrix x + translation. Plain data: code of every instruction set reads
/// it.
struct PosePoints {
  const double *source[3], *target[3];  ///< one array a coordinate
  double matrix[9];                     ///< row after row
  double translation[3];
};

/// Squared residuals of the first `num_blocks` blocks of 64 correspondences.
void squared_residuals_of_blocks(const PosePoints& points, Index num_blocks, double* squared);

/// Bit k says whether the squared residual of correspondence begin + k is at most
/// factor * squared_bounds[begin + k].
/// @param squared  64 values; those of the bits that are set are written.
std::uint64_t agreeing_of_block(const PosePoints& points, Index begin, const double* squared_bounds,
                                double factor, double* squared);

}  // namespace gmcr::kernels
