#include "frontend/alignment/align.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::frontend {
namespace {

constexpr Index kLeastPairs = 20;
/// Eigenvalues of the normal equations below this share of the largest say nothing.
constexpr double kRankTolerance = 1e-6;
constexpr double kMaxAngle = 0.35;  // radians a step
constexpr double kMaxGrowth = 0.1;  // relative change of the scale a step
constexpr int kMaxHalvings = 6;

using UpToSeven = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 7, 7>;

/// Solves for the step along the directions that the pairs determine.
MotionStep solve(const NormalEquations& equations, bool estimates_scale) {
  const Index size = estimates_scale ? 7 : 6;
  const UpToSeven matrix = equations.matrix.topLeftCorner(size, size);
  const Eigen::SelfAdjointEigenSolver<UpToSeven> solver(matrix);
  const auto& values = solver.eigenvalues();
  MotionStep step = MotionStep::Zero();
  for (Index k = 0; k < size; ++k) {
    if (!(values[k] > kRankTolerance * values[size - 1])) continue;
    const auto direction = solver.eigenvectors().col(k);
    step.head(size) -= direction * (direction.dot(equations.gradient.head(size)) / values[k]);
  }
  const double angle = step.head<3>().norm() / equations.lever;
  const double growth = std::abs(step[6]) / equations.lever;
  return step / std::max({1.0, angle / kMaxAngle, growth / kMaxGrowth});
}

/// The pose after the longest of the step, a half, a quarter and so on that is admitted.
std::optional<Similarity> admitted_step(MotionStep& step, const NormalEquations& equations,
                                        const AlignmentRules& rules, const Similarity& pose) {
  for (int halving = 0; halving <= kMaxHalvings; ++halving, step /= 2) {
    const Similarity next = moved_by(step, equations, pose);
    if (rules.admits(next)) return next;
  }
  return std::nullopt;
}

}  // namespace

Similarity moved_by(const MotionStep& step, const NormalEquations& equations,
                    const Similarity& pose) {
  const Eigen::Vector3d turn = step.head<3>() / equations.lever;
  const double angle = turn.norm();
  Similarity motion;
  if (angle > 0) motion.rotation = geometry::turn_about(turn / angle, angle);
  motion.scale = elementary::exp(step[6] / equations.lever);
  motion.translation =
      equations.pivot + step.segment<3>(3) - motion.scale * (motion.rotation * equations.pivot);
  Similarity next = motion * pose;
  next.rotation = Eigen::Quaterniond(next.rotation).normalized().toRotationMatrix();
  return next;
}

double kernel_of(const PlanePairs& pairs, const AlignmentRound& round) {
  return std::clamp(kKernelOfNoise * estimate_noise(pairs), round.least_kernel,
                    kKernelOfRadius * round.radius);
}

Similarity align(SurfaceCloud& source, SurfaceCloud& target, const Samples& samples,
                 const AlignmentRound& round, const AlignmentRules& rules, Similarity pose) {
  for (int k = 0; k < round.max_steps && !rules.deadline->expired(); ++k) {
    const PlanePairs pairs =
        find_pairs(source, target, samples, pose, round.radius, rules.num_threads);
    const auto num_agreeing = std::count_if(pairs.pairs.begin(), pairs.pairs.end(),
                                            [](const PlanePair& p) { return p.agreement > 0; });
    if (num_agreeing < kLeastPairs) break;
    const NormalEquations equations = normal_equations(pairs, kernel_of(pairs, round));
    MotionStep step = solve(equations, rules.estimates_scale);
    const auto next = admitted_step(step, equations, rules, pose);
    if (!next) break;
    pose = *next;
    if (step.norm() < round.least_step) break;
  }
  return pose;
}

}  // namespace gmcr::frontend
