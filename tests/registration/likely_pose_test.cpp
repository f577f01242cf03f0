#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gmcr/metrics.hpp"
#include "problems.hpp"
#include "random_geometry.hpp"

namespace gmcr::registration {
namespace {

using testing::Problem;
using testing::random_problem;

constexpr double kSigma = 0.01;

/// Right matches with Gaussian noise, and as many wrong ones.
Problem gaussian_problem(std::uint64_t seed, Index num_right, double bound) {
  Problem problem = random_problem(seed, num_right, num_right);
  testing::RandomGeometry random(seed + 1000);
  for (Index i = 0; i < num_right; ++i) {
    problem.target.col(i) = problem.truth * problem.source.col(i);
    for (Index axis = 0; axis < 3; ++axis) problem.target(axis, i) += kSigma * random.normal();
  }
  problem.noise_bound = bound;
  return problem;
}

Options options_of(const Problem& problem) {
  Options options = problem.options();
  options.noise_bound = problem.noise_bound;
  return options;
}

Result solve(const Problem& problem, const Options& options) {
  return register_correspondences(problem.source, problem.target, options);
}

double error_of(const Similarity& pose, const Problem& problem) {
  return mean_point_error(pose, problem.truth, problem.source);
}

/// Those within the bound at a pose.
std::vector<Index> within(const Similarity& pose, const Problem& problem) {
  std::vector<Index> inliers;
  for (Index i = 0; i < problem.source.cols(); ++i) {
    const double residual = (problem.target.col(i) - pose * problem.source.col(i)).norm();
    if (residual <= problem.noise_bound) inliers.push_back(i);
  }
  return inliers;
}

TEST(ReturnedPose, IsAsGoodAsTheFitToTheRightMatchesAtAnyBound) {
  for (const double factor : {1.5, 2.0, 3.0, 5.0, 6.0}) {
    double returned = 0, held = 0, best = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Problem problem = gaussian_problem(seed, 100, factor * kSigma);
      const Result result = solve(problem, options_of(problem));
      ASSERT_EQ(result.status, Status::Ok);
      const Eigen::MatrixXd source = problem.source.leftCols(100);
      const Eigen::MatrixXd target = problem.target.leftCols(100);
      Similarity fit;
      const Eigen::Matrix4d matrix = Eigen::umeyama(source, target, false);
      fit.rotation = matrix.topLeftCorner<3, 3>();
      fit.translation = matrix.topRightCorner<3, 1>();
      returned += error_of(result.target_from_source, problem);
      held += error_of(result.certificate.target_from_source, problem);
      best += error_of(fit, problem);
    }
    EXPECT_LT(returned, 1.3 * best) << factor;
    EXPECT_LT(returned, held) << factor;
  }
}

TEST(ReturnedPose, GivesItsOwnInliersAndTheCertificateThose) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Problem problem = gaussian_problem(seed, 40, 2 * kSigma);
    const Result result = solve(problem, options_of(problem));
    EXPECT_EQ(result.inliers, within(result.target_from_source, problem));
    const Certificate& certificate = result.certificate;
    EXPECT_EQ(certificate.inliers, within(certificate.target_from_source, problem));
    EXPECT_EQ(certificate.lower, static_cast<Index>(certificate.inliers.size()));
    EXPECT_GE(certificate.lower, static_cast<Index>(result.inliers.size()));
    EXPECT_GE(certificate.evidence.lower, result.evidence);
  }
}

TEST(ReturnedPose, OfThePapersMethodIsTheOneOfItsStages) {
  const Problem problem = gaussian_problem(1, 40, 3 * kSigma);
  Options options = options_of(problem);
  options.method = Method::Paper;
  const Result result = solve(problem, options);
  EXPECT_EQ(result.target_from_source.matrix(), result.certificate.target_from_source.matrix());
}

TEST(ReturnedPose, KeepsToThePriors) {
  const Problem problem = gaussian_problem(3, 40, 5 * kSigma);
  Options options = options_of(problem);
  // shorter than the truth, by less than the bound
  options.max_translation = problem.truth.translation.norm() - 2 * kSigma;
  const Result result = solve(problem, options);
  EXPECT_GE(result.inliers.size(), 30u);
  EXPECT_TRUE(options.admit(result.target_from_source));
}

TEST(ReturnedPose, LeavesNoInlierOfAnInstanceForTheNext) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Problem problem = random_problem(seed, 60, 0);
    const Problem other = random_problem(seed + 100, 60, 0);
    problem.source.conservativeResize(3, 120);
    problem.target.conservativeResize(3, 120);
    problem.source.rightCols(60) = other.source;
    problem.target.rightCols(60) = other.target;
    const auto found = register_instances(problem.source, problem.target, problem.options());
    ASSERT_EQ(found.size(), 2u);
    for (const Result& instance : found) {
      EXPECT_GE(instance.certificate.inliers.size(), instance.inliers.size());
      for (const Index i : instance.certificate.inliers) EXPECT_LT(i, 120);
    }
  }
}

TEST(ReturnedPose, OfAlternativesIsTheLikeliestToo) {
  Problem problem = gaussian_problem(5, 40, 5 * kSigma);
  const Problem other = gaussian_problem(6, 30, 5 * kSigma);
  problem.source.rightCols(30) = other.source.leftCols(30);
  problem.target.rightCols(30) = other.target.leftCols(30);
  Options options = options_of(problem);
  options.num_hypotheses = 2;
  const Result result = solve(problem, options);
  ASSERT_EQ(result.alternatives.size(), 1u);
  EXPECT_LT(error_of(result.alternatives.front().target_from_source, other), kSigma);
}

TEST(ReturnedPose, OfThreeCollinearInliersIsNotCalledDetermined) {
  Problem problem = random_problem(7, 0, 6);
  for (Index i = 0; i < 3; ++i) {
    problem.source.col(i) = Eigen::Vector3d(0.3 * static_cast<double>(i), 0, 0);
    problem.target.col(i) = problem.truth * problem.source.col(i);
  }
  EXPECT_NE(solve(problem, problem.options()).status, Status::Ok);
}

}  // namespace
}  // namespace gmcr::registration
