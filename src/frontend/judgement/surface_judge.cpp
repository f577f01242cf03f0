#include "frontend/judgement/surface_judge.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "frontend/alignment/plane_pairs.hpp"
#include "frontend/alignment/surface_fit.hpp"
#include "frontend/judgement/free_space.hpp"
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
constexpr double kStrays = 0.01;    // of the points, at either end

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

/// By some of its points, but for a few strays.
SurfaceJudge::Box SurfaceJudge::box_of_source() const {
  SurfaceCloud& source = pair_->source;
  const Samples samples = sample_side(source, true, kFewSamples);
  source.require_normals(samples.columns, options_.num_threads);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Index i : samples.columns) squares += source.normal(i) * source.normal(i).transpose();
  Box box{Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares).eigenvectors(), centroid_};
  const auto strays =
      static_cast<std::size_t>(kStrays * static_cast<double>(samples.columns.size()));
  for (const auto axis : box.axes.colwise()) {
    std::vector<double> places;
    for (const Index i : samples.columns) places.push_back(axis.dot(source.point(i)));
    std::sort(places.begin(), places.end());
    box.middle += axis * (places[strays] + places[places.size() - 1 - strays]) / 2;
  }
  return box;
}

Candidate SurfaceJudge::look(const Similarity& start, const RefinementScale& scale,
                             const Options& options, const parallel::Deadline& deadline) {
  const RefinedPose refined = refine_pose(*pair_, start, scale, options, deadline);
  const SurfaceFit fit = measure_surfaces(*pair_, refined.target_from_source, voxel_,
                                          scale.max_samples, options.num_threads);
  const double contradicted = measure_contradiction(*pair_, refined.target_from_source, voxel_,
                                                    scale.max_samples, options.num_threads);
  return {refined.target_from_source, refined.is_applied, refined.noise, fit.overlap(),
          contradicted};
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
  const auto add = [&](const Eigen::Vector3d& axis, const Eigen::Vector3d& centre) {
    Similarity turn;
    turn.rotation = geometry::turn_about(axis.normalized(), std::numbers::pi);
    turn.translation = centre - turn.rotation * centre;
    const Similarity candidate = pose * turn;
    if (options_.admit(candidate)) turned.push_back(candidate);
  };
  for (const auto axis : axes_.colwise()) add(axis, centroid_);
  const Box box = box_of_source();
  for (const auto axis : box.axes.colwise()) add(axis, box.middle);
  return turned;
}

std::vector<Similarity> SurfaceJudge::reflections(const Similarity& pose) const {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  std::vector<Similarity> reflected;
  const auto add = [&](const Eigen::Vector3d& axis, const Eigen::Vector3d& centre) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - 2 * axis * axis.transpose();
    Similarity turn;
    turn.rotation = across * mirror;
    turn.translation = centre - across * centre;
    reflected.push_back(pose * turn);
  };
  for (const auto axis : axes_.colwise()) add(axis, centroid_);
  const Box box = box_of_source();
  for (const auto axis : box.axes.colwise()) add(axis, box.middle);
  return reflected;
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
