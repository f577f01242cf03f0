#include "frontend/judgement/surface_judge.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "frontend/alignment/surface_fit.hpp"
#include "frontend/judgement/overlap.hpp"
#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kReach = 3;  // voxels: the matches put a pose within their noise bound
constexpr double kFarthestReach = 12;
constexpr double kLeastStep = 1e-2;  // voxels
constexpr Index kComparedSamples = 2500;
constexpr Index kFewSamples = 600;
constexpr Index kFewestSamples = 200;
constexpr double kLongStep = 0.5;   // voxels
constexpr double kSymmetric = 1.5;  // voxels
constexpr double kAlmostAll = 0.9;  // of the source

}  // namespace

SurfaceJudge::SurfaceJudge(std::shared_ptr<CentredPair> pair, double voxel, const Options& options)
    : pair_(std::move(pair)), voxel_(voxel), options_(options), alone_(options) {
  alone_.num_threads = 1;
  const Points& points = pair_->source.points();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(points * points.transpose() /
                                                              static_cast<double>(points.cols()));
  axes_ = solver.eigenvectors();
  variances_ = solver.eigenvalues();
  centroid_ = pair_->source_centre();
}

Candidate SurfaceJudge::look(const Similarity& start, const RefinementScale& scale,
                             const Options& options, const parallel::Deadline& deadline) {
  const RefinedPose refined = refine_pose(*pair_, start, scale, options, deadline);
  const SurfaceFit fit = measure_surfaces(*pair_, refined.target_from_source, voxel_,
                                          scale.max_samples, options.num_threads);
  return {refined.target_from_source, refined.is_applied, refined.noise, fit.overlap()};
}

std::vector<Candidate> SurfaceJudge::look_at_all(const std::vector<Similarity>& starts,
                                                 const RefinementScale& scale,
                                                 const parallel::Deadline& deadline) {
  std::vector<Candidate> found(starts.size());
  const Options& options = starts.size() > 1 ? alone_ : options_;
  parallel::parallel_for(std::ssize(starts), 1, options_.num_threads, [&](Index i, Index) {
    const auto k = static_cast<std::size_t>(i);
    found[k] = look(starts[k], scale, options, deadline);
  });
  return found;
}

Candidate SurfaceJudge::approach(const Similarity& start, const parallel::Deadline& deadline) {
  return look(start, {voxel_, kReach, kComparedSamples, kLeastStep}, options_, deadline);
}

Candidate SurfaceJudge::approach_initial_pose(double scale, const parallel::Deadline& deadline) {
  const InitialPose& prior = *options_.initial_pose;
  Similarity start = prior.target_from_source;
  start.scale = scale;
  const double size = std::sqrt(variances_.sum()) * scale;
  const double off = prior.max_translation + 2 * elementary::sin(prior.max_rotation / 2) * size;
  const double reach = std::clamp(off / voxel_, kReach, kFarthestReach);
  return look(start, {voxel_, reach, kComparedSamples, kLeastStep}, options_, deadline);
}

std::vector<Candidate> SurfaceJudge::glance(const std::vector<Similarity>& starts,
                                            const parallel::Deadline& deadline) {
  return look_at_all(starts, {voxel_, kReach, kFewSamples, kLeastStep}, deadline);
}

std::vector<Candidate> SurfaceJudge::peek(const std::vector<Similarity>& starts,
                                          const parallel::Deadline& deadline) {
  return look_at_all(starts, {voxel_, kReach, kFewestSamples, kLongStep}, deadline);
}

std::vector<Similarity> SurfaceJudge::half_turns(const Similarity& pose) const {
  std::vector<Similarity> turned;
  for (int axis = 0; axis < 3; ++axis) {
    Similarity turn;
    turn.rotation = geometry::turn_about(axes_.col(axis).normalized(), std::numbers::pi);
    turn.translation = centroid_ - turn.rotation * centroid_;
    const Similarity candidate = pose * turn;
    if (options_.admit(candidate)) turned.push_back(candidate);
  }
  return turned;
}

bool SurfaceJudge::is_symmetry(const Similarity& a, const Similarity& b) {
  const Similarity turn = pair_->centred(a).inverse() * pair_->centred(b);
  const double radius = kSymmetric * voxel_ / a.scale;
  const Overlap own =
      measure_overlap(pair_->source, pair_->source, turn, radius, options_.num_threads);
  return own.fitness >= kAlmostAll;
}

bool SurfaceJudge::are_distinct(const Similarity& a, const Similarity& b, double voxels) const {
  const Eigen::Vector3d shift = a * centroid_ - b * centroid_;
  const Eigen::Matrix3d linear = (a.scale * a.rotation - b.scale * b.rotation) * axes_;
  const double square =
      shift.squaredNorm() + linear.colwise().squaredNorm().dot(variances_.transpose());
  return square > voxels * voxels * voxel_ * voxel_;
}

}  // namespace gmcr::frontend
