#include "frontend/alignment/surface_covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "estimation/uncertainty/covariance.hpp"
#include "frontend/alignment/align.hpp"
#include "frontend/alignment/plane_metric.hpp"
#include "frontend/alignment/surface_fit.hpp"

namespace gmcr::frontend {
namespace {

using estimation::ParameterMatrix;

constexpr int kMostHalvings = 6;
constexpr std::size_t kLeastOfBlock = 8;
// Pairs after small motions, of half the noise between the surfaces.
constexpr Index kMovedSamples = 2000;
constexpr double kMotion = 0.5;
constexpr double kRounding = 1e-9;  // of the lever: copies have no noise
// Of the curvature where each point keeps its neighbour: less is noise of the measurement.
constexpr double kLeastCurvature = 0.05;
constexpr std::size_t kLeastMeeting = 16 * kLeastOfBlock;  // 7 parameters take 8 blocks at least

/// What the pairs say of motions about their weighted mean; rotation and scale times the lever.
struct Evidence {
  std::vector<Eigen::Vector3d> places;
  std::vector<MotionStep> pulls;  ///< half of the derivative of each cost, times the squared kernel
  ParameterMatrix curvature;      ///< half of the second derivative of their sum
  ParameterMatrix stiffness;      ///< mean square of a motion along the normals
};

Evidence evidence_of(const PlanePairs& pairs, double kernel, const NormalEquations& equations,
                     Index size) {
  Evidence evidence;
  evidence.curvature = equations.matrix.topLeftCorner(size, size);
  evidence.stiffness = ParameterMatrix::Zero(size, size);
  for (const PlanePair& pair : pairs.pairs) {
    const double weight = weight_of(pair, kernel);
    if (weight == 0) continue;
    const Eigen::Vector3d arm = (pair.moved - equations.pivot) / equations.lever;
    const MotionStep pull = pull_of(pair, arm), held = along(pair.normal, arm);
    // the weight falls as the pair moves apart
    const double fall = 4 * weight / (kernel * kernel + pair.squared_distance);
    evidence.curvature -= fall * pull.head(size) * pull.head(size).transpose();
    evidence.stiffness +=
        (weight / equations.weight) * held.head(size) * held.head(size).transpose();
    evidence.places.push_back(pair.moved);
    evidence.pulls.emplace_back(weight * pull);
  }
  return evidence;
}

/// Halves the pairs where they spread most, again and again, and visits what is left.
template <class Visit>
void for_each_block(const std::vector<Eigen::Vector3d>& places, std::span<std::size_t> pairs,
                    int halvings, const Visit& visit) {
  if (halvings == 0 || pairs.size() < 2 * kLeastOfBlock) return visit(pairs);
  Eigen::Array3d low = places[pairs.front()], high = low;
  for (const std::size_t k : pairs) {
    low = low.min(places[k].array());
    high = high.max(places[k].array());
  }
  Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t half = pairs.size() / 2;
  std::nth_element(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(half), pairs.end(),
                   [&](std::size_t a, std::size_t b) {
                     return std::pair(places[a][axis], a) < std::pair(places[b][axis], b);
                   });
  // summed in their order, whatever the library left it as
  std::sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(half));
  std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(half), pairs.end());
  for_each_block(places, pairs.first(half), halvings - 1, visit);
  for_each_block(places, pairs.subspan(half), halvings - 1, visit);
}

/// Covariance of the sum of the pulls.
ParameterMatrix scatter_of(const Evidence& evidence, Index size) {
  std::vector<std::size_t> pairs(evidence.pulls.size());
  std::iota(pairs.begin(), pairs.end(), std::size_t{0});
  ParameterMatrix scatter = ParameterMatrix::Zero(size, size);
  double num_blocks = 0;
  for_each_block(evidence.places, pairs, kMostHalvings, [&](std::span<const std::size_t> block) {
    MotionStep sum = MotionStep::Zero();
    for (const std::size_t k : block) sum += evidence.pulls[k];
    scatter += sum.head(size) * sum.head(size).transpose();
    num_blocks += 1;
  });
  return scatter * (num_blocks / (num_blocks - static_cast<double>(size)));
}

/// Half of the derivative of the mean cost, where points have the neighbours of this pose.
MotionStep mean_pull(CentredPair& clouds, const RefinedPose& refined, const Samples& samples,
                     const NormalEquations& equations, const Similarity& pose, int num_threads) {
  const PlanePairs found =
      find_pairs(clouds.source, clouds.target, samples, pose, refined.radius, num_threads);
  MotionStep sum = MotionStep::Zero();
  for (const PlanePair& pair : found.pairs) {
    const double weight = weight_of(pair, refined.kernel);
    if (weight == 0) continue;
    sum += weight * pull_of(pair, (pair.moved - equations.pivot) / equations.lever);
  }
  return sum / static_cast<double>(found.num_sought);
}

/// Half of the second derivative of the sum along some motions, where points find their neighbours
/// anew.
ParameterMatrix moved_curvature(CentredPair& clouds, const RefinedPose& refined,
                                const NormalEquations& equations, const ParameterMatrix& motions,
                                int num_threads) {
  const Samples samples = choose_samples(clouds.source, clouds.target, kMovedSamples);
  const Similarity pose = clouds.centred(refined.target_from_source);
  const double length =
      kMotion * std::max(estimate_noise(refined.pairs), kRounding * equations.lever);
  const auto pull_after = [&](const MotionStep& motion) {
    return mean_pull(clouds, refined, samples, equations, moved_by(motion, equations, pose),
                     num_threads);
  };
  ParameterMatrix curvature(motions.cols(), motions.cols());
  for (Index k = 0; k < motions.cols(); ++k) {
    MotionStep motion = MotionStep::Zero();
    motion.head(motions.rows()) = length * motions.col(k);
    const MotionStep change = pull_after(motion) - pull_after(-motion);
    curvature.col(k) = motions.transpose() * change.head(motions.rows()) / (2 * length);
  }
  return static_cast<double>(refined.pairs.num_sought) / 2 * (curvature + curvature.transpose());
}

/// L^-1 times a matrix, column by column: for all at once Eigen fuses sums and products on Arm.
ParameterMatrix by_lower(const Eigen::LLT<ParameterMatrix>& factors, ParameterMatrix matrix) {
  for (auto column : matrix.colwise()) factors.matrixL().solveInPlace(column);
  return matrix;
}

/// Of the parameters in metres, about the pivot.
ParameterMatrix in_metres(const Covariance& covariance, const Eigen::Vector3d& lever_arm,
                          double lever) {
  const ParameterMatrix central =
      estimation::parameters_from_central(-lever_arm, covariance.matrix.rows());
  ParameterMatrix metres = central * covariance.matrix * central.transpose();
  for (Index k = 0; k < metres.rows(); ++k) {
    if (k / 3 == 1) continue;  // the translation
    metres.row(k) *= lever;
    metres.col(k) *= lever;
  }
  return metres;
}

Covariance of_caller(ParameterMatrix metres, const Eigen::Vector3d& lever_arm, double lever) {
  Covariance covariance;
  covariance.eigenvalues =
      Eigen::SelfAdjointEigenSolver<ParameterMatrix>(metres, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .cwiseMax(0);
  for (Index k = 0; k < metres.rows(); ++k) {
    if (k / 3 == 1) continue;
    metres.row(k) /= lever;
    metres.col(k) /= lever;
  }
  const ParameterMatrix map = estimation::parameters_from_central(lever_arm, metres.rows());
  const ParameterMatrix matrix = map * metres * map.transpose();
  covariance.matrix = (matrix + matrix.transpose()) / 2;
  return covariance;
}

}  // namespace

std::optional<Covariance> surface_covariance(CentredPair& clouds, const RefinedPose& refined,
                                             bool estimates_scale,
                                             const std::optional<Covariance>& of_matches,
                                             int num_threads) {
  const auto num_meeting = std::count_if(refined.pairs.pairs.begin(), refined.pairs.pairs.end(),
                                         [](const PlanePair& pair) { return pair.agreement > 0; });
  if (static_cast<std::size_t>(num_meeting) < kLeastMeeting) return of_matches;
  const Index size = estimates_scale ? 7 : 6;
  const NormalEquations equations = normal_equations(refined.pairs, refined.kernel);
  const Evidence evidence = evidence_of(refined.pairs, refined.kernel, equations, size);

  const Eigen::SelfAdjointEigenSolver<ParameterMatrix> motions(evidence.stiffness);
  const Index num_weak = (motions.eigenvalues().array() < kWeakStiffness).count();
  if (num_weak == size || (num_weak > 0 && !of_matches)) return of_matches;
  const ParameterMatrix weak = motions.eigenvectors().leftCols(num_weak);
  const ParameterMatrix held = motions.eigenvectors().rightCols(size - num_weak);
  const Eigen::LLT<ParameterMatrix> curvature(held.transpose() * evidence.curvature * held);
  if (curvature.info() != Eigen::Success) return of_matches;
  // what the neighbours that change leave of it, direction by direction
  const ParameterMatrix half =
      by_lower(curvature, moved_curvature(clouds, refined, equations, held, num_threads));
  const Eigen::SelfAdjointEigenSolver<ParameterMatrix> shares(
      by_lower(curvature, half.transpose()));
  const ParameterMatrix root =
      shares.eigenvectors().transpose() * by_lower(curvature, held.transpose());
  const ParameterMatrix inverse =
      root.transpose() *
      shares.eigenvalues().cwiseMax(kLeastCurvature).cwiseMin(1).cwiseInverse().asDiagonal() * root;
  ParameterMatrix metres = inverse * scatter_of(evidence, size) * inverse;

  const Similarity& pose = refined.target_from_source;
  const Eigen::Vector3d lever_arm = equations.pivot +
                                    pose.scale * (pose.rotation * clouds.source_centre()) -
                                    clouds.centred(pose).translation;
  if (num_weak > 0) {
    const ParameterMatrix matched = in_metres(*of_matches, lever_arm, equations.lever);
    metres += weak * (weak.transpose() * matched * weak) * weak.transpose();
  }
  // copies are as sure as their digits
  const double digits = std::numeric_limits<double>::epsilon() *
                        (lever_arm.norm() + pose.translation.norm() + equations.lever);
  metres.diagonal().array() += digits * digits;
  return of_caller(std::move(metres), lever_arm, equations.lever);
}

}  // namespace gmcr::frontend
