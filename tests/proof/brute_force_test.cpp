// Bounds of small problems against every subset of the matches: what the certificate says no pose
// holds, a search of our own, which knows nothing of graphs, must not find.
#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "effort.hpp"
#include "gmcr/registration.hpp"
#include "random_geometry.hpp"

namespace gmcr::proof {
namespace {

using Eigen::Vector3d;

constexpr ScaleRange kScales{0.5, 2};

struct SmallProblem {
  Points source, target;
  std::vector<double> bounds;
};

/// Coordinates from a lattice coincide, are collinear and coplanar, and agree by chance.
SmallProblem any_problem(testing::RandomGeometry& random, bool scale_is_known) {
  const Index n = 3 + random.index(6);
  SmallProblem problem{random.in_cube(n), Points(3, n), {}};
  const bool is_lattice = random.index(3) == 0;
  if (is_lattice) problem.source = (4 * problem.source.array()).round();
  if (random.index(5) == 0) problem.source.row(2).setZero();
  const Similarity truth = random.similarity(scale_is_known ? 1 : 0.6, scale_is_known ? 1 : 1.8, 2);
  const double bound = random.uniform(0.02, 0.4) * (is_lattice ? 2 : 1);
  const Index num_wrong = random.index(n);
  for (Index i = 0; i < n; ++i) {
    const Vector3d exact = truth * problem.source.col(i);
    problem.target.col(i) = i < num_wrong ? Vector3d(exact + random.in_ball(1.2))
                                          : Vector3d(exact + random.in_ball(1.1 * bound));
  }
  const bool is_mixed = random.index(3) == 0;
  for (Index i = 0; i < n; ++i) {
    problem.bounds.push_back(is_mixed ? bound * random.uniform(0.3, 2) : bound);
  }
  return problem;
}

/// The weighted least-squares pose of the matches of a subset.
Similarity weighted_fit(const SmallProblem& problem, const std::vector<Index>& subset,
                        const std::vector<double>& weights, bool scale_is_known) {
  double sum = 0;
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();
  for (std::size_t k = 0; k < subset.size(); ++k) {
    sum += weights[k];
    from += weights[k] * problem.source.col(subset[k]);
    to += weights[k] * problem.target.col(subset[k]);
  }
  from /= sum;
  to /= sum;
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double spread = 0;
  for (std::size_t k = 0; k < subset.size(); ++k) {
    const Vector3d a = problem.source.col(subset[k]) - from, b = problem.target.col(subset[k]) - to;
    products += weights[k] * b * a.transpose();
    spread += weights[k] * a.squaredNorm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs = Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) signs(2) = -1;
  Similarity pose;
  pose.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  if (!scale_is_known && spread > 0) {
    pose.scale = std::clamp(svd.singularValues().dot(signs) / spread, kScales.min, kScales.max);
  }
  pose.translation = to - pose.scale * (pose.rotation * from);
  return pose;
}

double relative_residual(const SmallProblem& problem, const Similarity& pose, Index i) {
  return (problem.target.col(i) - pose * problem.source.col(i)).norm() /
         problem.bounds[static_cast<std::size_t>(i)];
}

/// A pose that holds the whole subset, by least squares that weigh the worst up (Lawson 1961).
std::optional<Similarity> holding_pose(const SmallProblem& problem,
                                       const std::vector<Index>& subset, bool scale_is_known) {
  constexpr int kFits = 60;
  constexpr double kMargin = 1e-9;  // below the bound, so that no rounding finds a pose
  std::vector<double> weights;
  for (const Index i : subset) {
    weights.push_back(1 / std::pow(problem.bounds[static_cast<std::size_t>(i)], 2));
  }
  for (int fit = 0; fit < kFits; ++fit) {
    const Similarity pose = weighted_fit(problem, subset, weights, scale_is_known);
    double worst = 0, sum = 0;
    for (std::size_t k = 0; k < subset.size(); ++k) {
      const double residual = relative_residual(problem, pose, subset[k]);
      worst = std::max(worst, residual);
      weights[k] *= std::max(residual, 1e-6);
      sum += weights[k];
    }
    if (worst <= 1 - kMargin) return pose;
    for (double& weight : weights) weight /= sum;
  }
  return {};
}

std::vector<Index> members(unsigned subset) {
  std::vector<Index> indices;
  for (; subset != 0; subset &= subset - 1) indices.push_back(std::countr_zero(subset));
  return indices;
}

/// Whether all pairs can be inliers of one rigid pose: spares most fits.
bool agrees(const SmallProblem& problem, const std::vector<Index>& subset) {
  for (const Index i : subset) {
    for (const Index j : subset) {
      const double from = (problem.source.col(i) - problem.source.col(j)).norm();
      const double to = (problem.target.col(i) - problem.target.col(j)).norm();
      if (std::abs(from - to) > problem.bounds[static_cast<std::size_t>(i)] +
                                    problem.bounds[static_cast<std::size_t>(j)]) {
        return false;
      }
    }
  }
  return true;
}

/// Looks for a pose of more inliers, or of more evidence, than the upper bounds.
void expect_no_better_pose(const SmallProblem& problem, const Options& options,
                           const Certificate& certificate) {
  const bool scale_is_known = options.scale_mode == ScaleMode::Known;
  const auto n = static_cast<unsigned>(problem.source.cols());
  for (unsigned subset = 1; subset < 1U << n; ++subset) {
    const int size = std::popcount(subset);
    // of larger sets the subsets of these sizes would be found
    if (size != certificate.upper + 1 && size != std::max<Index>(3, certificate.lower)) continue;
    const std::vector<Index> indices = members(subset);
    if (scale_is_known && !agrees(problem, indices)) continue;
    const auto pose = holding_pose(problem, indices, scale_is_known);
    if (!pose) continue;
    ASSERT_LE(size, certificate.upper);
    const Consensus consensus = evaluate_consensus(*pose, problem.source, problem.target, options);
    ASSERT_LE(static_cast<Index>(consensus.inliers.size()), certificate.upper);
    ASSERT_LE(consensus.evidence, certificate.evidence.upper * (1 + 1e-9));
  }
}

void expect_recounted(const SmallProblem& problem, const Certificate& certificate) {
  ASSERT_EQ(certificate.lower, static_cast<Index>(certificate.inliers.size()));
  for (const Index i : certificate.inliers) {
    ASSERT_LE(relative_residual(problem, certificate.target_from_source, i), 1 + 1e-9);
  }
  ASSERT_EQ(certificate.certified, certificate.lower == certificate.upper);
}

TEST(BruteForce, FindsNoPoseAboveTheBounds) {
  constexpr int kProblems = 400;
  int num_certified = 0, num_solved = 0;
  for (int i = 0; i < kProblems * test::effort(); ++i) {
    testing::RandomGeometry random(static_cast<std::uint64_t>(i));
    const bool scale_is_known = i % 3 != 0;
    const SmallProblem problem = any_problem(random, scale_is_known);
    Options options;
    options.noise_bounds = problem.bounds;
    options.evidence = i % 2 == 0 ? Evidence::Distinct : Evidence::Count;
    options.certify = i % 4 != 3;
    options.num_threads = 1;
    if (!scale_is_known) {
      options.scale_mode = ScaleMode::Estimated;
      options.scale_range = kScales;
    }
    const Result result = register_correspondences(problem.source, problem.target, options);
    SCOPED_TRACE(::testing::Message() << "problem " << i);
    expect_recounted(problem, result.certificate);
    expect_no_better_pose(problem, options, result.certificate);
    if (HasFatalFailure()) return;
    num_certified += result.certificate.certified;
    ++num_solved;
  }
  EXPECT_GT(num_certified, num_solved / 2);
  RecordProperty("certified", num_certified);
}

}  // namespace
}  // namespace gmcr::proof
