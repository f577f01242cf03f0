#include "estimation/uncertainty/covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "estimation/closed_forms/similarity_fit.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

constexpr ScaleRange kFreeScale{1e-6, 1e6};

/// Exact correspondences of an anisotropic cloud under a known transform.
struct Case {
  Points source, target;
  Similarity truth;
  Eigen::ArrayXd bounds;
  std::vector<Index> indices;
};

Case make_case(std::uint64_t seed, Index count, const Eigen::Vector3d& extent, double scale,
               const Eigen::Vector3d& source_offset = Eigen::Vector3d::Zero()) {
  testing::RandomGeometry random(seed);
  Case c;
  c.truth = random.similarity(scale, scale, 2);
  c.source = extent.asDiagonal() * random.in_cube(count);
  c.source.colwise() += source_offset;
  c.target = c.truth.apply(c.source);
  c.bounds = Eigen::ArrayXd::Constant(count, 0.1);
  c.indices.resize(static_cast<std::size_t>(count));
  std::iota(c.indices.begin(), c.indices.end(), Index{0});
  return c;
}

/// Gaussian noise on the targets, of standard deviation share * bounds_i an axis.
Points noisy_target(const Case& c, testing::RandomGeometry& random, double share = 0.1) {
  Points target = c.target;
  for (Index i = 0; i < target.cols(); ++i) {
    for (Index axis = 0; axis < 3; ++axis) target(axis, i) += share * c.bounds[i] * random.normal();
  }
  return target;
}

std::optional<Covariance> covariance_of(const Case& c, bool scale_is_free) {
  const ScaleRange scales = scale_is_free ? kFreeScale : ScaleRange{c.truth.scale, c.truth.scale};
  const auto fit = fit_similarity(c.source, c.target, c.bounds, c.indices, scales);
  return estimate_covariance(*fit, c.source, c.target, c.bounds, c.indices, scale_is_free);
}

/// (omega, tau, sigma) that lead from `from` to `to`.
Eigen::VectorXd parameters(const Similarity& from, const Similarity& to, bool scale_is_free) {
  const Eigen::AngleAxisd turn(to.rotation * from.rotation.transpose());
  Eigen::VectorXd p(scale_is_free ? 7 : 6);
  p.head<3>() = turn.angle() * turn.axis();
  p.segment<3>(3) = to.translation - from.translation;
  if (scale_is_free) p[6] = std::log(to.scale / from.scale);
  return p;
}

/// Compares the covariance of fits to noisy targets with the mean of their estimates.
void expect_agrees_with_experiment(const Case& c, bool scale_is_free) {
  constexpr int kTrials = 2000;
  testing::RandomGeometry random(99);
  const Index dimension = scale_is_free ? 7 : 6;
  const ScaleRange scales = scale_is_free ? kFreeScale : ScaleRange{c.truth.scale, c.truth.scale};
  Eigen::MatrixXd empirical = Eigen::MatrixXd::Zero(dimension, dimension), estimate = empirical;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Points target = noisy_target(c, random);
    const auto fit = fit_similarity(c.source, target, c.bounds, c.indices, scales);
    const Eigen::VectorXd p = parameters(c.truth, *fit, scale_is_free);
    empirical += p * p.transpose() / kTrials;
    const auto covariance =
        estimate_covariance(*fit, c.source, target, c.bounds, c.indices, scale_is_free);
    ASSERT_TRUE(covariance);
    estimate += covariance->matrix / kTrials;
  }
  // whitened by the estimate the experiment has unit variance in every direction, to its own
  // statistical error: eigenvalues of a Wishart matrix of d variables in n trials are within
  // (1 +- sqrt(d / n))^2 = [0.88, 1.12] of 1
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ratio(empirical, estimate);
  EXPECT_GT(ratio.eigenvalues().minCoeff(), 0.83);
  EXPECT_LT(ratio.eigenvalues().maxCoeff(), 1.17);
}

TEST(EstimateCovariance, AgreesWithTheSpreadOfRigidFits) {
  expect_agrees_with_experiment(make_case(1, 20, {5, 1, 0.3}, 1), false);
}

TEST(EstimateCovariance, AgreesWithTheSpreadOfSimilarityFits) {
  expect_agrees_with_experiment(make_case(2, 20, {5, 1, 0.5}, 2.5), true);
}

TEST(EstimateCovariance, AgreesWithTheSpreadOfFitsToOffsetClouds) {
  expect_agrees_with_experiment(make_case(3, 15, {2, 3, 1}, 0.7, {20, -30, 5}), true);
}

TEST(EstimateCovariance, AgreesWithTheSpreadOfWeightedFits) {
  Case c = make_case(4, 20, {2, 1, 1}, 1);
  testing::RandomGeometry random(5);
  for (Index i = 0; i < c.bounds.size(); ++i) c.bounds[i] = random.uniform(0.02, 0.5);
  expect_agrees_with_experiment(c, false);
  expect_agrees_with_experiment(c, true);
}

TEST(EstimateCovariance, OfThreeCorrespondencesExists) {
  Case c = make_case(6, 3, {1, 1, 1}, 1);
  testing::RandomGeometry random(7);
  c.target = noisy_target(c, random);
  for (const bool free : {false, true}) {
    const auto covariance = covariance_of(c, free);
    ASSERT_TRUE(covariance);
    EXPECT_EQ(covariance->matrix.rows(), free ? 7 : 6);
    EXPECT_EQ(covariance->eigenvalues.size(), free ? 7 : 6);
    EXPECT_GT(covariance->eigenvalues[0], 0);
  }
  c.indices = {0, 1};
  EXPECT_FALSE(estimate_covariance(c.truth, c.source, c.target, c.bounds, c.indices, false));
}

TEST(EstimateCovariance, MovesWithTheFrames) {
  const Eigen::Vector3d offset(1e6, -2e6, 3e6);
  Case c = make_case(8, 30, {2, 1, 1}, 1.5);
  testing::RandomGeometry random(9);
  c.target = noisy_target(c, random);
  Case far = c;
  far.source.colwise() += offset;
  far.target.colwise() -= offset;
  const auto near_covariance = covariance_of(c, true), far_covariance = covariance_of(far, true);
  // the eigenvalues are about the centroid, the turn and the scale do not see the origin
  EXPECT_LT((far_covariance->eigenvalues - near_covariance->eigenvalues).norm(),
            1e-6 * near_covariance->eigenvalues.norm());
  const Eigen::Matrix3d near_turn = near_covariance->matrix.block(0, 0, 3, 3);
  const Eigen::Matrix3d far_turn = far_covariance->matrix.block(0, 0, 3, 3);
  EXPECT_LT((far_turn - near_turn).norm(), 1e-6 * near_turn.norm());
  EXPECT_NEAR(far_covariance->matrix(6, 6) / near_covariance->matrix(6, 6), 1, 1e-6);
  // t is the image of an origin that is far away: its turn moves it much
  EXPECT_GT(far_covariance->matrix(3, 3), 1e9 * near_covariance->matrix(3, 3));
}

TEST(EstimateCovariance, FollowsTheUnitOfLength) {
  Case c = make_case(10, 30, {2, 1, 1}, 1.5);
  testing::RandomGeometry random(11);
  c.target = noisy_target(c, random);
  Case millimetres = c;
  millimetres.source *= 1000;
  millimetres.target *= 1000;
  millimetres.bounds *= 1000;
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(7);
  unit.segment<3>(3).setConstant(1000);
  const auto in_metres = covariance_of(c, true), in_millimetres = covariance_of(millimetres, true);
  const Eigen::MatrixXd expected = unit.asDiagonal() * in_metres->matrix * unit.asDiagonal();
  EXPECT_LT((in_millimetres->matrix - expected).norm(), 1e-9 * expected.norm());
  EXPECT_LT((in_millimetres->eigenvalues - 1e6 * in_metres->eigenvalues).norm(),
            1e-9 * in_millimetres->eigenvalues.norm());
}

TEST(EstimateCovariance, DoesNotDependOnTheOrder) {
  Case c = make_case(12, 25, {1, 1, 1}, 1);
  testing::RandomGeometry random(13);
  c.target = noisy_target(c, random);
  Case reversed = c;
  std::reverse(reversed.indices.begin(), reversed.indices.end());
  const auto one = covariance_of(c, true), other = covariance_of(reversed, true);
  EXPECT_LT((one->matrix - other->matrix).norm(), 1e-9 * one->matrix.norm());
}

TEST(EstimateCovariance, HardlyDependsOnTheSizeOfAllBounds) {
  Case c = make_case(14, 25, {1, 1, 1}, 1);
  testing::RandomGeometry random(15);
  c.target = noisy_target(c, random);
  const auto one = covariance_of(c, true);
  c.bounds *= 1.5;
  EXPECT_LT((covariance_of(c, true)->matrix - one->matrix).norm(), 0.05 * one->matrix.norm());
}

TEST(EstimateCovariance, AlmostForgetsAPointOfLooseBound) {
  Case c = make_case(16, 25, {1, 1, 1}, 1);
  testing::RandomGeometry random(17);
  c.target = noisy_target(c, random);
  Case without = c;
  without.indices.pop_back();
  c.bounds[24] = 1e6;
  const auto weighted = covariance_of(c, true), removed = covariance_of(without, true);
  // the loose point still adds its three degrees of freedom
  EXPECT_LT((weighted->matrix - removed->matrix).norm(), 0.1 * removed->matrix.norm());
}

TEST(EstimateCovariance, CountsMatchesThatShareTheirErrorOnce) {
  constexpr Index kClusters = 30, kEach = 6;
  constexpr int kTrials = 400;
  Case c = make_case(22, kClusters * kEach, {10, 8, 6}, 1);
  testing::RandomGeometry random(23);
  for (Index i = 0; i < c.source.cols(); ++i) {
    if (i % kEach > 0) c.source.col(i) = c.source.col(i - i % kEach) + random.in_ball(0.02);
  }
  c.target = c.truth.apply(c.source);
  double distance = 0;  // squared, of the true error, over its expectation
  for (int trial = 0; trial < kTrials; ++trial) {
    Case noisy = c;
    for (Index i = 0; i < c.source.cols(); i += kEach) {
      const Eigen::Vector3d error =
          0.03 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      noisy.target.middleCols(i, kEach).colwise() += error;
    }
    const auto fit = fit_similarity(noisy.source, noisy.target, c.bounds, c.indices, {1, 1});
    const Eigen::VectorXd error = parameters(*fit, c.truth, false);
    const auto covariance = covariance_of(noisy, false);
    distance += error.dot(covariance->matrix.inverse() * error) / 6 / kTrials;
  }
  EXPECT_GT(distance, 0.6);
  EXPECT_LT(distance, 1.6);
}

TEST(EstimateCovariance, OfNearlyCollinearPointsHasOneLargeEigenvalue) {
  Case c = make_case(18, 30, {10, 0.01, 0.01}, 1);
  testing::RandomGeometry random(19);
  c.target = noisy_target(c, random, 0.001);
  const auto covariance = covariance_of(c, false);
  ASSERT_TRUE(covariance);
  EXPECT_GT(covariance->eigenvalues[5], 1e4 * covariance->eigenvalues[4]);
  // it is the turn about the line of the points
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> turn(covariance->matrix.block(0, 0, 3, 3));
  const Eigen::Vector3d line = c.truth.rotation * Eigen::Vector3d::UnitX();
  EXPECT_GT(std::abs(turn.eigenvectors().col(2).dot(line)), 0.999);
}

TEST(EstimateCovariance, OfCollinearOrCoincidentPointsDoesNotExist) {
  Case c = make_case(20, 10, {3, 0, 0}, 1);
  EXPECT_FALSE(covariance_of(c, false));
  EXPECT_FALSE(covariance_of(c, true));
  c.source.setConstant(1);
  c.target.setConstant(2);
  EXPECT_FALSE(covariance_of(c, true));
}

TEST(EstimateCovariance, OfExactDataIsThatOfRounding) {
  const Case c = make_case(21, 40, {1, 1, 1}, 1);
  const auto covariance = covariance_of(c, true);
  ASSERT_TRUE(covariance);
  EXPECT_GT(covariance->eigenvalues[0], 0);
  EXPECT_LT(covariance->eigenvalues[6], 1e-28);
}

}  // namespace
}  // namespace gmcr::estimation
