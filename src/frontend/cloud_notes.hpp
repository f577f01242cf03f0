#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontend/features/cloud_scales.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// A cloud without the copies of a point that fills a good part of it.
struct DistinctCloud {
  std::optional<Points> kept;  ///< nullopt: there is no such point, and the cloud is as it was
  Index num_copies = 0;        ///< that were left out
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< metres
};

/// Leaves one of the copies of the median point, where these are more than 1 % of the cloud: such
/// as the zeros of an organised cloud, which would steer the voxel size. Cost O(N).
DistinctCloud without_repeats(const PointsRef& points);

/// Adds what is odd about two clouds to the notes of their result, a sentence each. A pose of
/// coordinates in coarse steps is doubtful at best.
/// @param source, target  without repeats.
/// @param from, to        what `without_repeats` left out of them.
void add_notes(CloudResult& result, CloudScales& source, CloudScales& target,
               const DistinctCloud& from, const DistinctCloud& to, const FrontendOptions& frontend,
               const Options& options);

}  // namespace gmcr::frontend
