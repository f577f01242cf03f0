#pragma once

#include <vector>

#include "frontend/judgement/surface_judge.hpp"
#include "gmcr/options.hpp"
#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// A whole object, and a cloud that may be what a sensor sees of it.
struct ObjectAndView {
  const Points& object;       ///< voxels, metres, source frame
  const Points& view;         ///< voxels, metres, target frame
  double voxel = 0;           ///< metres, target frame
  Eigen::Vector3d viewpoint;  ///< of the sensor, metres, target frame
};

/// Whether the view is about as large as the object, which has few enough voxels to be turned all
/// around, and was seen from outside.
bool may_show(const ObjectAndView& clouds, double scale);

/// Smallest of 1, sqrt(2), 2 and so on by which a voxel has to grow to merge points of a sparse
/// cloud.
double coarsening_of(const PointsRef& points, double voxel_size);

/// Poses at which the view may show the object: it is turned to the sensor from all around, what
/// would be seen of it is put where the view lies, and the surfaces are aligned on coarse voxels.
///
/// The features of a small noisy object tell little, its surface as a whole tells more.
/// @param options  the priors, the known scale and `num_threads` are read.
/// @return at most six, those whose surfaces meet best on the coarse voxels first.
/// Deterministic for any thread count, but for the deadline.
std::vector<Similarity> poses_by_views(const ObjectAndView& clouds, const Options& options,
                                       const parallel::Deadline& deadline);

}  // namespace gmcr::frontend
