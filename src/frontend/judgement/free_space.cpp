#include "frontend/judgement/free_space.hpp"

#include <algorithm>
#include <vector>

#include "frontend/alignment/plane_pairs.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kCovered = 2;  // voxels
constexpr double kBehind = 3;   // voxels

/// One side in the frame of the other, about its centre, and what was seen from there.
struct Seen {
  SurfaceCloud& by;
  const RangeImage& view;
  Eigen::Vector3d centre;  ///< metres, the caller's frame
  double voxel;            ///< metres
};

double share_in_free_space(const Points& moved, const Seen& seen, int num_threads) {
  const std::vector<Index> nearest = seen.by.nearest(moved, kCovered * seen.voxel, num_threads);
  const Eigen::Vector3d from_viewpoint = seen.centre - seen.view.viewpoint();
  double num_covered = 0, num_free = 0;
  for (Index i = 0; i < moved.cols(); ++i) {
    if (nearest[static_cast<std::size_t>(i)] >= 0) {
      ++num_covered;
    } else {
      num_free += seen.view.sees_through(moved.col(i) + from_viewpoint, kBehind * seen.voxel);
    }
  }
  return num_free > 0 ? num_free / (num_free + num_covered) : 0;
}

Points some_of(const SurfaceCloud& cloud, Index max_samples) {
  const Samples samples = sample_side(cloud, true, max_samples);
  Points points(3, std::ssize(samples.columns));
  for (Index i = 0; i < points.cols(); ++i) {
    points.col(i) = cloud.point(samples.columns[static_cast<std::size_t>(i)]);
  }
  return points;
}

}  // namespace

double measure_contradiction(CentredPair& pair, const Similarity& target_from_source, double voxel,
                             Index max_samples, int num_threads) {
  const Similarity pose = pair.centred(target_from_source);
  double worst = 0;
  if (pair.target_view) {
    worst = share_in_free_space(pose.apply(some_of(pair.source, max_samples)),
                                {pair.target, *pair.target_view, pair.target_centre(), voxel},
                                num_threads);
  }
  if (pair.source_view) {
    const double back = share_in_free_space(
        pose.inverse().apply(some_of(pair.target, max_samples)),
        {pair.source, *pair.source_view, pair.source_centre(), voxel / pose.scale}, num_threads);
    worst = std::max(worst, back);
  }
  return worst;
}

}  // namespace gmcr::frontend
