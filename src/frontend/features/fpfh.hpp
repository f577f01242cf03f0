#pragma once

#include <Eigen/Core>

#include "frontend/points/neighbourhoods.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

inline constexpr int kFpfhBins = 33;

/// 33 x N, column i is the feature of point i.
using Features = Eigen::Matrix<float, kFpfhBins, Eigen::Dynamic>;

/// Fast point feature histograms (Rusu, Blodow and Beetz, ICRA 2009).
///
/// Three histograms of 11 bins each, of the angles theta, alpha and phi between the normals of a
/// point and of its neighbours; the histogram of the point plus the mean of its neighbours'
/// histograms, weighted by the inverse squared distance. Each sums to 200.
/// Unchanged by a rigid motion or a change of unit of points and normals together.
/// @param points, normals  3 x N; normals are unit, or 0 where there is none.
/// @param neighbourhoods   of the points; pairs without a normal or at distance 0 are skipped.
/// @return 0 in the columns of points without a normal or without neighbours.
/// Cost O(number of neighbours). Deterministic for any thread count.
Features compute_fpfh(const PointsRef& points, const Points& normals,
                      const Neighbourhoods& neighbourhoods, int num_threads);

}  // namespace gmcr::frontend
