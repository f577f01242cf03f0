#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::Problem;
using testing::random_problem;

constexpr double kLooseBound = 0.05;  // five times the noise

Options loosely(Options options) {
  options.noise_bound = kLooseBound;
  options.least_squares = true;
  return options;
}

Result solve(const Problem& problem, const Options& options) {
  return register_correspondences(problem.source, problem.target, options);
}

/// The fit by Eigen. @param known_scale  0: not known.
Eigen::Matrix4d least_squares_of(const Problem& problem, const std::vector<Index>& inliers,
                                 double known_scale) {
  const double scale = known_scale > 0 ? known_scale : 1;
  const Eigen::MatrixXd source = scale * problem.source(Eigen::all, inliers);
  const Eigen::MatrixXd target = problem.target(Eigen::all, inliers);
  Eigen::Matrix4d fit = Eigen::umeyama(source, target, known_scale == 0);
  fit.leftCols<3>() *= scale;
  return fit;
}

TEST(LeastSquares, IsTheFitToTheInliersThatAreReported) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Problem problem = random_problem(seed, 12, 20, 1.5);
    for (const bool is_scale_known : {true, false}) {
      for (const Method method : {Method::Gmcr, Method::Paper}) {
        Options options =
            loosely(is_scale_known ? problem.options() : problem.options_with_unknown_scale());
        options.method = method;
        const Result result = solve(problem, options);
        const Eigen::Matrix4d fit =
            least_squares_of(problem, result.inliers, is_scale_known ? 1.5 : 0);
        EXPECT_TRUE(result.target_from_source.matrix().isApprox(fit, 1e-9));
        EXPECT_EQ(result.certificate.lower, static_cast<Index>(result.inliers.size()));
      }
    }
  }
}

TEST(LeastSquares, IsCloserToTheTruthWhereTheBoundIsLoose) {
  double held = 0, fitted = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Problem problem = random_problem(seed, 40, 160);
    Options options = loosely(problem.options());
    const auto error = [&] {
      return mean_point_error(solve(problem, options).target_from_source, problem.truth,
                              problem.source);
    };
    fitted += error();
    options.least_squares = false;
    held += error();
  }
  EXPECT_LT(fitted, 0.8 * held);
}

TEST(LeastSquares, HoldsNoMoreThanThePoseThatHoldsTheMost) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Problem problem = random_problem(seed, 40, 160);
    Options options = loosely(problem.options());
    const Result fitted = solve(problem, options);
    options.least_squares = false;
    const Result most = solve(problem, options);
    EXPECT_LE(fitted.evidence, most.evidence);
    EXPECT_EQ(fitted.certificate.upper, most.certificate.upper);
    EXPECT_GE(fitted.certificate.upper, fitted.certificate.lower);
  }
}

TEST(LeastSquares, KeepsToThePriors) {
  const Problem problem = random_problem(3, 40, 60);
  Options options = loosely(problem.options());
  // shorter than the truth, by less than the bound
  options.max_translation = problem.truth.translation.norm() - 0.02;
  const Result result = solve(problem, options);
  EXPECT_GE(result.inliers.size(), 30u);
  EXPECT_TRUE(options.admit(result.target_from_source));
}

TEST(LeastSquares, LeavesTheEstimatedNoiseBoundAsItIs) {
  const Problem problem = random_problem(4, 40, 60);
  Options options = problem.options();
  options.noise_mode = NoiseMode::Estimated;
  options.noise_bound = 0;
  const Result most = solve(problem, options);
  options.least_squares = true;
  const Result fitted = solve(problem, options);
  ASSERT_TRUE(fitted.noise_estimate && most.noise_estimate);
  EXPECT_EQ(fitted.noise_estimate->noise_bound, most.noise_estimate->noise_bound);
  EXPECT_TRUE(fitted.target_from_source.matrix().isApprox(
      least_squares_of(problem, fitted.inliers, 1), 1e-9));
}

TEST(LeastSquares, FindsTheInstancesThatTheSearchFinds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Problem problem = random_problem(seed, 60, 0);
    const Problem other = random_problem(seed + 100, 60, 0);
    problem.source.conservativeResize(3, 120);
    problem.target.conservativeResize(3, 120);
    problem.source.rightCols(60) = other.source;
    problem.target.rightCols(60) = other.target;
    Options options = problem.options();
    options.least_squares = true;
    const auto found = register_instances(problem.source, problem.target, options);
    ASSERT_EQ(found.size(), 2u);
    for (const Result& instance : found) {
      EXPECT_TRUE(instance.target_from_source.matrix().isApprox(
          least_squares_of(problem, instance.inliers, 1), 1e-9));
    }
  }
}

TEST(LeastSquares, OfAlternativesToo) {
  Problem problem = random_problem(5, 40, 0);
  const Problem other = random_problem(6, 30, 0);
  problem.source.conservativeResize(3, 70);
  problem.target.conservativeResize(3, 70);
  problem.source.rightCols(30) = other.source;
  problem.target.rightCols(30) = other.target;
  Options options = loosely(problem.options());
  options.num_hypotheses = 2;
  const Result result = solve(problem, options);
  ASSERT_EQ(result.alternatives.size(), 1u);
  const Alternative& alternative = result.alternatives.front();
  EXPECT_TRUE(alternative.target_from_source.matrix().isApprox(
      least_squares_of(problem, alternative.inliers, 1), 1e-9));
}

TEST(LeastSquares, OfThreeCollinearInliersIsDegenerate) {
  Problem problem = random_problem(7, 0, 6);
  for (Index i = 0; i < 3; ++i) {
    problem.source.col(i) = Eigen::Vector3d(0.3 * static_cast<double>(i), 0, 0);
    problem.target.col(i) = problem.truth * problem.source.col(i);
  }
  const Result result = solve(problem, [&] {
    Options options = problem.options();
    options.least_squares = true;
    return options;
  }());
  EXPECT_NE(result.status, Status::Ok);
}

}  // namespace
}  // namespace gmcr::registration
