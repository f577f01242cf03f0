#include "frontend/surface_judge.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <numbers>

#include "frontend/alignment/surface_fit.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kReach = 3;  // voxels: the matches put a pose within their noise bound
constexpr Index kMaxSamples = 2500;
constexpr double kDistinct = 3;  // voxels

}  // namespace

SurfaceJudge::SurfaceJudge(const CloudMatches& matches, const Options& options)
    : pair_(matches.source_voxels, matches.target_voxels),
      voxel_(matches.target_voxel_size),
      options_(options) {
  const Points& points = matches.source_voxels;
  const Eigen::Vector3d first = points.col(0);
  const Eigen::Vector3d mean = (points.colwise() - first).rowwise().mean();
  centroid_ = first + mean;
  const Points arms = (points.colwise() - first).colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(arms * arms.transpose() /
                                                              static_cast<double>(points.cols()));
  axes_ = solver.eigenvectors();
  variances_ = solver.eigenvalues();
}

Candidate SurfaceJudge::approach(const Similarity& start, const parallel::Deadline& deadline) {
  const RefinedPose refined =
      refine_pose(pair_, start, {voxel_, kReach, kMaxSamples}, options_, deadline);
  const SurfaceFit fit =
      measure_surfaces(pair_, refined.target_from_source, voxel_, options_.num_threads);
  return {refined.target_from_source, refined.is_applied, refined.noise, fit.overlap()};
}

std::vector<Similarity> SurfaceJudge::half_turns(const Similarity& pose) const {
  std::vector<Similarity> turned;
  for (int axis = 0; axis < 3; ++axis) {
    Similarity turn;
    turn.rotation =
        Eigen::AngleAxisd(std::numbers::pi, axes_.col(axis).normalized()).toRotationMatrix();
    turn.translation = centroid_ - turn.rotation * centroid_;
    const Similarity candidate = pose * turn;
    if (options_.admit(candidate)) turned.push_back(candidate);
  }
  return turned;
}

bool SurfaceJudge::are_distinct(const Similarity& a, const Similarity& b) const {
  const Eigen::Vector3d shift = a * centroid_ - b * centroid_;
  const Eigen::Matrix3d linear = (a.scale * a.rotation - b.scale * b.rotation) * axes_;
  const double square =
      shift.squaredNorm() + linear.colwise().squaredNorm().dot(variances_.transpose());
  return square > kDistinct * kDistinct * voxel_ * voxel_;
}

}  // namespace gmcr::frontend
