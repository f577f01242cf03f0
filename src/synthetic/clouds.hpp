#pragma once

#include <vector>

#include "gmcr/synthetic.hpp"
#include "synthetic/random.hpp"

namespace gmcr::synthetic {

/// `count` points uniform in the cube of edge 1 around the origin.
Points cube_points(Index count, Random& random);

/// `count` different points of the model, scaled with it so that its box is centred at the origin
/// and has the largest side 1.
/// @throws std::invalid_argument where the model has too few points, one that is not finite, or no
///   extent.
Points model_points(const PointsRef& model, Index count, Random& random);

/// Image of `source` with noise, followed by the points of the sphere: the paper's target cloud.
Points paper_target_cloud(const SyntheticOptions& options, const Similarity& target_from_source,
                          const Points& source, Random& random);

/// The `count` points of the first `num_points` of `cloud` that are nearest to point `centre`,
/// itself left out; nearest first, ties to the smaller index; fewer where the cloud has no more.
std::vector<Index> nearest_points(const Points& cloud, Index num_points, Index centre, Index count);

}  // namespace gmcr::synthetic
