#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Index of a point, correspondence or vertex.
using Index = Eigen::Index;

/// 3 x N, column i is point i, metres. A C-order numpy array of shape (N, 3) has the same layout.
using Points = Eigen::Matrix3Xd;

/// Read-only view of points; binds to `Points` and to mapped memory of that layout without a copy.
/// A row-major matrix is copied.
using PointsRef = Eigen::Ref<const Points>;

}  // namespace gmcr
