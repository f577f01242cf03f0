#include "refine.hpp"

#include <fmt/core.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/utility/Logging.h>

#include <limits>

#include "gmcr/metrics.hpp"
#include "stopwatch.hpp"

namespace gmcr::cli {
namespace {

using Open3DCloud = open3d::geometry::PointCloud;
namespace icp = open3d::pipelines::registration;

// In voxels of the target. The first pass catches what the pose is off by, the second fits closely.
constexpr double kIcpDistances[] = {2, 1};
constexpr double kNormalRadius = 2.5;
constexpr int kNormalNeighbors = 30;
constexpr int kIterations = 30;
// A pose that loses more than this is another pose, not a finer one.
constexpr double kLeastFitnessKept = 0.98;
constexpr double kLeastInliersKept = 0.8;
constexpr Index kLeastInliers = 3;

Open3DCloud to_open3d(const Points& points) {
  Open3DCloud cloud;
  cloud.points_.reserve(static_cast<std::size_t>(points.cols()));
  for (Index i = 0; i < points.cols(); ++i) cloud.points_.emplace_back(points.col(i));
  return cloud;
}

std::vector<Index> inliers_of(const CloudMatches& matches, const Similarity& pose, double bound) {
  std::vector<Index> inliers;
  for (Index i = 0; i < matches.source.cols(); ++i) {
    const Eigen::Vector3d image = pose * matches.source.col(i);
    if ((matches.target.col(i) - image).norm() <= bound) inliers.push_back(i);
  }
  return inliers;
}

/// The pose that ICP moves `pose` to; the scale stays.
Similarity run_icp(const CloudMatches& matches, const Similarity& pose) {
  const double voxel = matches.target_voxel_size;
  const Open3DCloud source = to_open3d(pose.apply(matches.source_voxels));
  Open3DCloud target = to_open3d(matches.target_voxels);
  target.EstimateNormals(
      open3d::geometry::KDTreeSearchParamHybrid(kNormalRadius * voxel, kNormalNeighbors));
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

/// Fitness and RMSE as `CloudResult` defines them.
struct Overlap {
  double fitness = 0;
  double rmse = 0;
  double target_fitness = 0;
};

Overlap evaluate(const CloudMatches& matches, const Similarity& pose) {
  const Open3DCloud source = to_open3d(pose.apply(matches.source_voxels));
  const Open3DCloud target = to_open3d(matches.target_voxels);
  const auto forth = icp::EvaluateRegistration(source, target, matches.target_voxel_size);
  const auto back = icp::EvaluateRegistration(target, source, matches.target_voxel_size);
  return {forth.fitness_, forth.inlier_rmse_, back.fitness_};
}

void adopt(CloudResult& result, const Similarity& pose, std::vector<Index> inliers,
           const Overlap& overlap, const Options& options) {
  Result& registration = result.registration;
  // the weights of distinct evidence stay inside the library
  registration.evidence = options.evidence == Evidence::Count
                              ? static_cast<double>(inliers.size())
                              : std::numeric_limits<double>::quiet_NaN();
  registration.target_from_source = pose;
  registration.inliers = std::move(inliers);
  Certificate& certificate = registration.certificate;
  certificate.lower = static_cast<Index>(registration.inliers.size());
  certificate.certified = certificate.lower == certificate.upper;
  result.fitness = overlap.fitness;
  result.overlap_rmse = overlap.rmse;
  result.target_fitness = overlap.target_fitness;
}

Refinement refine(CloudResult& result, const Options& options) {
  const Similarity before = result.registration.target_from_source;
  const auto inliers_before = static_cast<Index>(result.registration.inliers.size());
  const Similarity after = run_icp(result.matches, before);
  const Overlap overlap = evaluate(result.matches, after);
  std::vector<Index> inliers =
      inliers_of(result.matches, after, result.matches.noise_bound / options.threshold);
  const auto num_inliers = static_cast<Index>(inliers.size());
  const bool keeps_overlap = overlap.fitness >= kLeastFitnessKept * result.fitness;
  const bool keeps_inliers =
      num_inliers >= kLeastInliers &&
      static_cast<double>(num_inliers) >= kLeastInliersKept * static_cast<double>(inliers_before);
  if (!keeps_overlap || !keeps_inliers) {
    return {"icp", false,
            fmt::format("ICP was rejected: it would change fitness {:.3f} to {:.3f} and {} inliers "
                        "to {}",
                        result.fitness, overlap.fitness, inliers_before, num_inliers)};
  }
  const std::string note =
      fmt::format("ICP turned the pose by {:.3f} deg; {} inliers became {}",
                  rotation_error_deg(after.rotation, before.rotation), inliers_before, num_inliers);
  adopt(result, after, std::move(inliers), overlap, options);
  return {"icp", true, note};
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
