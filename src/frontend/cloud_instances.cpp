#include <algorithm>
#include <cstddef>
#include <utility>

#include "frontend/alignment/surface_cloud.hpp"
#include "frontend/judgement/verdict.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"

namespace gmcr {
namespace {

/// Target points nearer than that to the voxels of an instance are its own.
constexpr double kOwnRadius = 1.5;  // voxels
/// Poses at which less than this share of the source lies in the same place are two instances.
constexpr double kSamePlace = 0.1;

/// The source voxels where the instance is.
frontend::SurfaceCloud surface_of(const CloudResult& instance, const Eigen::Vector3d& centre) {
  const Similarity& pose = instance.registration.target_from_source;
  const CloudMatches& matches = instance.matches;
  return {pose.apply(matches.source_voxels), centre, matches.target_voxel_size};
}

/// The points of the target that are not an instance's own.
Points without(const Points& target, const CloudResult& instance, int num_threads) {
  const Eigen::Vector3d centre = target.col(0);
  frontend::SurfaceCloud own = surface_of(instance, centre);
  const double radius = kOwnRadius * instance.matches.target_voxel_size;
  const std::vector<Index> nearest = own.nearest(target.colwise() - centre, radius, num_threads);
  std::vector<Index> left;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] < 0) left.push_back(static_cast<Index>(i));
  }
  return target(Eigen::all, left);
}

/// Judges an instance where poses elsewhere are other instances, not rivals.
void judge_by_its_place(CloudResult& instance, int num_threads) {
  if (instance.rivals.empty()) return;
  const Points& voxels = instance.matches.source_voxels;
  const Eigen::Vector3d centre = instance.registration.target_from_source * voxels.col(0);
  frontend::SurfaceCloud own = surface_of(instance, centre);
  const double radius = kOwnRadius * instance.matches.target_voxel_size;
  std::erase_if(instance.rivals, [&](const RivalPose& rival) {
    const Points moved = rival.target_from_source.apply(voxels).colwise() - centre;
    const auto nearest = own.nearest(moved, radius, num_threads);
    const auto count =
        std::count_if(nearest.begin(), nearest.end(), [](Index i) { return i >= 0; });
    return static_cast<double>(count) < kSamePlace * static_cast<double>(nearest.size());
  });
  frontend::judge(instance);
}

}  // namespace

std::vector<CloudResult> register_cloud_instances(const PointsRef& source, const PointsRef& target,
                                                  const FrontendOptions& frontend,
                                                  const Options& options,
                                                  const InstanceOptions& instances) {
  instances.validate();
  const parallel::Deadline deadline(options.time_limit, options.stop);
  Points left = target;
  std::vector<CloudResult> found;
  while (static_cast<int>(found.size()) < instances.max_instances) {
    if (!found.empty() && deadline.expired()) {
      found.front().registration.diagnostics.limits_hit.push_back(
          {Limit::Time, "the time budget ended the search for further instances"});
      break;
    }
    Options remaining = options;
    remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
    CloudResult instance = register_clouds(source, left, frontend, remaining);
    judge_by_its_place(instance, options.num_threads);
    const bool is_found = instance.registration.status == Status::Ok;
    const bool is_more =
        is_found && instance.verdict != Verdict::Untrusted &&
        static_cast<Index>(instance.registration.inliers.size()) >=
            instances.min_instance_inliers &&
        (found.empty() || instance.distinct_evidence >=
                              instances.min_instance_share * found.front().distinct_evidence);
    if (!found.empty() && !is_more) break;
    if (is_found) left = without(left, instance, options.num_threads);
    found.push_back(std::move(instance));
    if (!is_more || left.cols() == 0) break;
  }
  return found;
}

}  // namespace gmcr
