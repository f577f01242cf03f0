#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "problems.hpp"
#include "random_geometry.hpp"

namespace gmcr::registration {
namespace {

using testing::random_problem;

/// d' C^-1 d of the error d.
double squared_distance(const Result& result, const Similarity& truth) {
  const Eigen::AngleAxisd turn(truth.rotation * result.target_from_source.rotation.transpose());
  Eigen::VectorXd error(6);
  error.head<3>() = turn.angle() * turn.axis();
  error.tail<3>() = truth.translation - result.target_from_source.translation;
  return error.dot(result.covariance->matrix.inverse() * error);
}

TEST(Uncertainty, OfARigidResultHasSixParametersAndOneScale) {
  const auto problem = random_problem(1, 60, 60, 2);
  const Result result = register_correspondences(problem.source, problem.target, problem.options());
  ASSERT_EQ(result.status, Status::Ok);
  ASSERT_TRUE(result.covariance);
  EXPECT_EQ(result.covariance->matrix.rows(), 6);
  EXPECT_EQ(result.consistent_scales.min, 2);
  EXPECT_EQ(result.consistent_scales.max, 2);
}

TEST(Uncertainty, OfASimilarityHasSevenParametersAndHoldsTheTrueScale) {
  const auto problem = random_problem(2, 60, 60, 2);
  const Result result = register_correspondences(problem.source, problem.target,
                                                 problem.options_with_unknown_scale());
  ASSERT_EQ(result.status, Status::Ok);
  ASSERT_TRUE(result.covariance);
  EXPECT_EQ(result.covariance->matrix.rows(), 7);
  EXPECT_LT(result.consistent_scales.min, 2);
  EXPECT_GT(result.consistent_scales.max, 2);
  EXPECT_LT(result.consistent_scales.max - result.consistent_scales.min, 0.1);
  EXPECT_LE(result.consistent_scales.min, result.target_from_source.scale);
  EXPECT_GE(result.consistent_scales.max, result.target_from_source.scale);
}

TEST(Uncertainty, CoversTheErrorOfMostResults) {
  int num_within = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto problem = random_problem(seed, 40, 40);
    const Result result =
        register_correspondences(problem.source, problem.target, problem.options());
    ASSERT_TRUE(result.covariance);
    // 95 % of a chi-squared variable of 6 degrees of freedom
    num_within += squared_distance(result, problem.truth) < 12.6;
  }
  EXPECT_GE(num_within, 25);
}

TEST(Uncertainty, IsTrueAtAnyBound) {
  constexpr double kDeviation = 0.01;
  constexpr Index kRight = 60;
  for (const double factor : {2.0, 3.0, 5.0}) {
    int num_outside = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      auto problem = random_problem(seed, kRight, kRight);
      testing::RandomGeometry random(seed + 500);
      for (Index i = 0; i < kRight; ++i) {
        problem.target.col(i) = problem.truth * problem.source.col(i);
        for (Index axis = 0; axis < 3; ++axis) {
          problem.target(axis, i) += kDeviation * random.normal();
        }
      }
      Options options = problem.options();
      options.noise_bound = factor * kDeviation;
      const Result result = register_correspondences(problem.source, problem.target, options);
      ASSERT_TRUE(result.covariance);
      num_outside += squared_distance(result, problem.truth) > 12.6;
    }
    EXPECT_GE(num_outside, 2) << factor;  // 5 are expected
    EXPECT_LE(num_outside, 9) << factor;
  }
}

TEST(PoseGraphCovariance, IsOfThePerturbationOfThatGraph) {
  testing::RandomGeometry random(1);
  const Similarity pose = random.similarity(1, 1, 2);
  Covariance covariance;
  const Eigen::MatrixXd factor = Eigen::MatrixXd::Random(7, 7);
  covariance.matrix = factor * factor.transpose();
  constexpr double kStep = 1e-6;
  for (const PoseGraph convention : {PoseGraph::Gtsam, PoseGraph::Ros}) {
    // what the graph's parameters become where ours move
    Eigen::Matrix<double, 6, 6> map;
    for (Index k = 0; k < 6; ++k) {
      Eigen::Matrix<double, 6, 1> ours = kStep * Eigen::Matrix<double, 6, 1>::Unit(k);
      Similarity moved = pose;
      moved.rotation = Eigen::AngleAxisd(ours.head<3>().norm(), ours.head<3>().normalized().eval())
                           .toRotationMatrix() *
                       pose.rotation;
      moved.translation += ours.tail<3>();
      const Similarity right = pose.inverse() * moved;  // T^-1 T'
      const Eigen::AngleAxisd in_source(right.rotation);
      const Eigen::AngleAxisd in_target(
          Eigen::Matrix3d(moved.rotation * pose.rotation.transpose()));
      Eigen::Matrix<double, 6, 1> theirs;
      if (convention == PoseGraph::Gtsam) {
        theirs << in_source.angle() * in_source.axis(), right.translation;
      } else {
        theirs << moved.translation - pose.translation, in_target.angle() * in_target.axis();
      }
      map.col(k) = theirs / kStep;
    }
    const Eigen::Matrix<double, 6, 6> expected =
        map * covariance.matrix.topLeftCorner<6, 6>() * map.transpose();
    EXPECT_LT((pose_graph_covariance(covariance, pose, convention) - expected).norm(),
              1e-4 * expected.norm());
  }
}

TEST(Uncertainty, OfADegenerateResultIsNotGiven) {
  Points source(3, 20);
  for (Index i = 0; i < 20; ++i) source.col(i) = static_cast<double>(i) * Eigen::Vector3d(1, 2, 3);
  Options options;
  options.noise_bound = 0.01;
  const Result result = register_correspondences(source, source, options);
  EXPECT_EQ(result.status, Status::Degenerate);
  EXPECT_FALSE(result.covariance);
}

TEST(EvaluateUncertainty, IsThatOfTheResult) {
  const auto problem = random_problem(3, 60, 60);
  for (const bool unknown_scale : {false, true}) {
    const Options options =
        unknown_scale ? problem.options_with_unknown_scale() : problem.options();
    const Result result = register_correspondences(problem.source, problem.target, options);
    const Uncertainty uncertainty = evaluate_uncertainty(result.target_from_source, problem.source,
                                                         problem.target, result.inliers, options);
    ASSERT_TRUE(uncertainty.covariance);
    EXPECT_EQ(uncertainty.covariance->matrix, result.covariance->matrix);
    EXPECT_EQ(uncertainty.covariance->eigenvalues, result.covariance->eigenvalues);
    EXPECT_EQ(uncertainty.consistent_scales.min, result.consistent_scales.min);
    EXPECT_EQ(uncertainty.consistent_scales.max, result.consistent_scales.max);
  }
}

TEST(EvaluateUncertainty, GivesNoCovarianceToPointsThatStayWithinTheNoise) {
  auto problem = random_problem(4, 20, 0);
  problem.source.bottomRows<2>() *= 0.01;
  problem.target = problem.truth.apply(problem.source);
  const std::vector<Index> inliers = {0, 1, 2, 3, 4, 5, 6, 7};
  Options options = problem.options();
  options.noise_bound = 0.1;
  EXPECT_FALSE(evaluate_uncertainty(problem.truth, problem.source, problem.target, inliers, options)
                   .covariance);
  options.noise_bound = 1e-4;
  EXPECT_TRUE(evaluate_uncertainty(problem.truth, problem.source, problem.target, inliers, options)
                  .covariance);
  EXPECT_FALSE(
      evaluate_uncertainty(problem.truth, problem.source, problem.target, {}, options).covariance);
}

TEST(EvaluateUncertainty, RefusesAnIndexOutOfRange) {
  const auto problem = random_problem(5, 5, 0);
  for (const Index bad : {-1, 5}) {
    EXPECT_THROW(evaluate_uncertainty(problem.truth, problem.source, problem.target, {0, 1, bad},
                                      problem.options()),
                 std::invalid_argument);
  }
}

TEST(EvaluateConsensus, RefusesAPoseThatIsNone) {
  const auto problem = testing::random_problem(2, 10, 0);
  Similarity pose = problem.truth;
  pose.scale = 0;
  EXPECT_THROW(evaluate_consensus(pose, problem.source, problem.target, problem.options()),
               std::invalid_argument);
  pose.scale = std::nan("");
  EXPECT_THROW(
      evaluate_uncertainty(pose, problem.source, problem.target, {0, 1, 2}, problem.options()),
      std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::registration
