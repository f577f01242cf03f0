#include "estimation/closed_forms/moments.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "estimation/closed_forms/similarity_fit.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

Moments moments_of(const Points& source, const Points& target, const Eigen::ArrayXd& bounds) {
  Moments moments;
  for (Index i = 0; i < source.cols(); ++i) {
    moments += point_moments(source.col(i), target.col(i), 1 / (bounds[i] * bounds[i]));
  }
  return moments;
}

double cost(const Similarity& pose, const Points& source, const Points& target,
            const Eigen::ArrayXd& bounds) {
  const Eigen::ArrayXd norms = (target - pose.apply(source)).colwise().norm();
  return (norms / bounds).square().sum();
}

struct MomentsCase {
  Points source, target;
  Eigen::ArrayXd bounds;
  ScaleRange scales;
};

MomentsCase random_case(testing::RandomGeometry& random) {
  const Index count = 2 + random.index(8);
  MomentsCase c;
  c.source = random.in_cube(count);
  if (random.index(4) == 0) c.source.row(2).setZero();                                  // coplanar
  if (random.index(6) == 0) c.source = c.source.col(0) * random.in_cube(count).row(0);  // collinear
  c.target = random.similarity(0.5, 2, 1).apply(c.source);
  if (random.index(2) == 0) c.target = random.in_cube(count);
  if (random.index(4) == 0) c.target.row(0) *= -1;  // mirrored
  c.bounds = Eigen::ArrayXd::NullaryExpr(count, [&] { return random.uniform(0.01, 1); });
  const double min = random.uniform(0.2, 2);
  c.scales = {min, random.index(2) == 0 ? min : min + random.uniform(0, 2)};
  return c;
}

TEST(LeastSquaresBound, IsTheCostOfTheClosedForm) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const MomentsCase c = random_case(random);
    if (c.source.cols() < 3) continue;
    std::vector<Index> all(static_cast<std::size_t>(c.source.cols()));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
    const auto fit = fit_similarity(c.source, c.target, c.bounds, all, c.scales);
    const double least = cost(*fit, c.source, c.target, c.bounds);
    const double bound = least_squares_bound(moments_of(c.source, c.target, c.bounds), c.scales);
    EXPECT_LE(bound, least + 1e-12 * least);
    EXPECT_GE(bound, least - 1e-5 * (1 + least)) << "trial " << trial;
  }
}

TEST(LeastSquaresBound, IsBelowTheCostOfAnyTransform) {
  testing::RandomGeometry random(2);
  for (int trial = 0; trial < 300; ++trial) {
    const MomentsCase c = random_case(random);
    const double bound = least_squares_bound(moments_of(c.source, c.target, c.bounds), c.scales);
    for (int k = 0; k < 50; ++k) {
      const Similarity pose = random.similarity(c.scales.min, c.scales.max, 1);
      EXPECT_LE(bound, cost(pose, c.source, c.target, c.bounds));
    }
  }
}

TEST(LeastSquaresBound, StaysBelowTheTruthFarFromTheOriginAndOnALargeScale) {
  testing::RandomGeometry random(3);
  for (const double size : {1e-3, 1.0, 1e6}) {
    for (const double offset : {0.0, 1e3, 1e6}) {
      const Points source = (size * random.in_cube(6)).array() + offset * size;
      const Points target = random.similarity(1, 1, 1).apply(source);
      const Eigen::ArrayXd bounds = Eigen::ArrayXd::Constant(6, 1e-4 * size);
      EXPECT_LE(least_squares_bound(moments_of(source, target, bounds), {1, 1}), 1e-6);
    }
  }
}

TEST(Moments, OfAUnionAreTheSum) {
  testing::RandomGeometry random(4);
  const Points source = random.in_cube(9), target = random.in_cube(9);
  const Eigen::ArrayXd bounds = Eigen::ArrayXd::Ones(9);
  Moments sum = moments_of(source.leftCols(4), target.leftCols(4), bounds.head(4));
  sum += moments_of(source.rightCols(5), target.rightCols(5), bounds.tail(5));
  const double whole = least_squares_bound(moments_of(source, target, bounds), {0.5, 2});
  EXPECT_NEAR(least_squares_bound(sum, {0.5, 2}), whole, 1e-12);
  EXPECT_NEAR(least_squares_bound(sum * 3, {0.5, 2}), 3 * whole, 1e-12);
}

TEST(MeasureMoments, OfRowsAreTheSumOverThePoints) {
  testing::RandomGeometry random(5);
  for (const Index count : {1, 2, 3, 8, 9}) {
    const Points source = random.in_cube(count), target = random.in_cube(count);
    const Eigen::ArrayXd bounds =
        Eigen::ArrayXd::NullaryExpr(count, [&] { return random.uniform(0.1, 1); });
    const Moments expected = moments_of(source, target, bounds);
    const Moments m =
        measure_moments(source.transpose(), target.transpose(), bounds.square().inverse());
    EXPECT_NEAR(m.weight, expected.weight, 1e-12 * expected.weight);
    EXPECT_LT((m.source_mean - expected.source_mean).norm(), 1e-14);
    EXPECT_LT((m.target_mean - expected.target_mean).norm(), 1e-14);
    EXPECT_LT((m.covariance - expected.covariance).norm(), 1e-12 * expected.weight);
    EXPECT_NEAR(m.source_variance, expected.source_variance, 1e-12 * expected.weight);
    EXPECT_NEAR(m.target_variance, expected.target_variance, 1e-12 * expected.weight);
  }
}

TEST(MeasureMoments, OfRowsWithoutWeightAreNothing) {
  const Eigen::MatrixX3d points = Eigen::MatrixX3d::Ones(4, 3);
  const Moments m = measure_moments(points, points, Eigen::ArrayXd::Zero(4));
  EXPECT_EQ(m.weight, 0);
  EXPECT_EQ(m.covariance, Eigen::Matrix3d::Zero());
}

TEST(LeastSquaresBound, OfNothingAndOfOnePointIsZero) {
  EXPECT_EQ(least_squares_bound({}, {1, 1}), 0);
  Moments one;
  one += point_moments({1, 2, 3}, {4, 5, 6}, 2);
  EXPECT_EQ(least_squares_bound(one, {1, 1}), 0);
}

}  // namespace
}  // namespace gmcr::estimation
