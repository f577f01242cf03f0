#pragma once

#include <Eigen/Core>

#include "gmcr/types.hpp"

namespace gmcr::geometry {

/// Correspondences as one array a coordinate, the layout that the kernels read.
struct CorrespondenceArrays {
  Eigen::MatrixX3d source, target;  ///< N x 3, metres
  Eigen::ArrayXd bounds;            ///< N inlier bounds, metres

  Index size() const { return source.rows(); }
};

}  // namespace gmcr::geometry
