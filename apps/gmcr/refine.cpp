#include "refine.hpp"

#include <fmt/core.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/utility/Logging.h>

#include <utility>

#include "gmcr/metrics.hpp"
#include "stopwatch.hpp"

namespace gmcr::cli {
namespace {

using Open3DCloud = open3d::geometry::PointCloud;
namespace icp = open3d::pipelines::registration;

// In voxels of the target. The first pass catches what the pose is off by, the second fits closely.
constexpr double kIcpDistances[] = {2, 1};
constexpr double kNormalRadius = 2.5;
constexpr int kNormalNeighbours = 30;
constexpr int kIterations = 30;
// A pose that loses more than this is another pose, not a finer one.
constexpr double kLeastFitnessKept = 0.98;
constexpr double kLeastInliersKept = 0.8;
constexpr std::size_t kLeastInliers = 3;

Open3DCloud to_open3d(const Points& points) {
  Open3DCloud cloud;
  cloud.points_.reserve(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) cloud.points_.emplace_back(points.col(i));
  return cloud;
}

/// The pose that ICP moves `pose` to; the scale stays.
Similarity run_icp(const CloudMatches& matches, const Similarity& pose) {
  const double voxel = matches.target_voxel_size;
  const Open3DCloud source = to_open3d(pose.apply(matches.source_voxels));
  Open3DCloud target = to_open3d(matches.target_voxels);
  target.EstimateNormals(
      open3d::geometry::KDTreeSearchParamHybrid(kNormalRadius * voxel, kNormalNeighbours));
  Eigen::Matrix4d step = Eigen::Matrix4d::Identity();
  for (const double distance : kIcpDistances) {
    step = icp::RegistrationICP(source, target, distance * voxel, step,
                                icp::TransformationEstimationPointToPlane(),
                                icp::ICPConvergenceCriteria(1e-6, 1e-6, kIterations))
               .transformation_;
  }
  Similarity refined = Similarity::from_matrix(step) * pose;
  refined.scale = pose.scale;
  return refined;
}

Refinement refine(CloudResult& result, const Options& options) {
  const Similarity before = result.registration.target_from_source;
  const Similarity after = run_icp(result.matches, before);
  if (!options.admit(after)) {
    return {"icp", false, "ICP was rejected: it would leave what the priors admit"};
  }
  CloudResult refined = with_pose(result, after, options);
  const std::size_t inliers_before = result.registration.inliers.size();
  const std::size_t num_inliers = refined.registration.inliers.size();
  const bool keeps_overlap = refined.fitness >= kLeastFitnessKept * result.fitness;
  const bool keeps_inliers =
      num_inliers >= kLeastInliers &&
      static_cast<double>(num_inliers) >= kLeastInliersKept * static_cast<double>(inliers_before);
  if (!keeps_overlap || !keeps_inliers) {
    return {"icp", false,
            fmt::format("ICP was rejected: it would change fitness {:.3f} to {:.3f} and {} inliers "
                        "to {}",
                        result.fitness, refined.fitness, inliers_before, num_inliers)};
  }
  result = std::move(refined);
  return {"icp", true,
          fmt::format("ICP turned the pose by {:.3f} deg; {} inliers became {}",
                      rotation_error_deg(after.rotation, before.rotation), inliers_before,
                      num_inliers)};
}

}  // namespace

Refinement refine_with_icp(CloudResult& result, const Options& options) {
  if (result.registration.status != Status::Ok) return {"icp", false, "no pose to refine"};
  const open3d::utility::VerbosityContextManager quiet(open3d::utility::VerbosityLevel::Error);
  const Stopwatch stopwatch;
  Refinement refinement;
  try {
    refinement = refine(result, options);
  } catch (const std::runtime_error& error) {
    refinement = {"icp", false, std::string("ICP failed: ") + error.what()};
  }
  result.registration.diagnostics.stages.push_back({"refinement", stopwatch.seconds()});
  return refinement;
}

}  // namespace gmcr::cli
