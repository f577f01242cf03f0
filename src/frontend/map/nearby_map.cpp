#include "frontend/map/nearby_map.hpp"

#include <algorithm>
#include <vector>

namespace gmcr::frontend {
namespace {

/// That say how surely the pose is determined; more of them say the same again.
constexpr std::size_t kMostMatches = 1000;

}  // namespace

Points points_within(const PointsRef& points, const Eigen::Vector3d& position, double radius) {
  std::vector<Index> columns;
  for (Index i = 0; i < points.cols(); ++i) {
    if ((points.col(i) - position).squaredNorm() <= radius * radius) columns.push_back(i);
  }
  return points(Eigen::all, columns);
}

void match_by_pose(CloudMatches& matches, CentredPair& voxels, const Similarity& target_from_source,
                   int num_threads) {
  const Points moved = voxels.centred(target_from_source).apply(voxels.source.points());
  const std::vector<Index> nearest = voxels.target.nearest(moved, matches.noise_bound, num_threads);
  std::vector<Index> met;
  for (Index i = 0; i < moved.cols(); ++i) {
    if (nearest[static_cast<std::size_t>(i)] >= 0) met.push_back(i);
  }
  const std::size_t count = std::min(kMostMatches, met.size());
  for (std::size_t k = 0; k < count; ++k) {
    const Index i = met[k * met.size() / count];
    matches.source_indices.push_back(i);
    matches.target_indices.push_back(nearest[static_cast<std::size_t>(i)]);
  }
  matches.source = matches.source_voxels(Eigen::all, matches.source_indices);
  matches.target = matches.target_voxels(Eigen::all, matches.target_indices);
}

}  // namespace gmcr::frontend
