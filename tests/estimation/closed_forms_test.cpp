#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "estimation/closed_forms/rotation.hpp"
#include "estimation/closed_forms/scale.hpp"
#include "estimation/closed_forms/translation.hpp"
#include "estimation/uncertainty/spread.hpp"
#include "gmcr/metrics.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

TEST(EstimateScale, WeighsAMeasurementByTheInverseSquareOfItsAlpha) {
  const Eigen::Array2d scales(1, 2), alphas(1, 0.5);
  EXPECT_DOUBLE_EQ(estimate_scale(scales, alphas), (1 * 1 + 2 * 4) / 5.0);
}

TEST(EstimateScale, IgnoresMeasurementsWithoutWeightAndIsNanWithoutAny) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(estimate_scale(Eigen::Array2d(3, inf), Eigen::Array2d(1, inf)), 3);
  EXPECT_TRUE(std::isnan(estimate_scale(Eigen::Array2d(inf, inf), Eigen::Array2d(inf, inf))));
}

TEST(EstimateRotation, RecoversAKnownRotation) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d truth = random.rotation();
    const Points a = random.in_cube(2 + random.index(10));
    const auto estimate = estimate_rotation(a, truth * a);
    ASSERT_TRUE(estimate);
    EXPECT_LT(rotation_error_deg(*estimate, truth), 1e-6);
  }
}

TEST(EstimateRotation, IsNeverAReflection) {
  testing::RandomGeometry random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Points a = random.in_cube(4);
    const auto estimate = estimate_rotation(a, -a);
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->determinant(), 1, 1e-12);
    EXPECT_LT((estimate->transpose() * *estimate - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  }
}

TEST(EstimateRotation, OfCoplanarVectorsIsUnique) {
  testing::RandomGeometry random(3);
  const Eigen::Matrix3d truth = random.rotation();
  Points a = random.in_cube(6);
  a.row(2).setZero();
  const auto estimate = estimate_rotation(a, truth * a);
  ASSERT_TRUE(estimate);
  EXPECT_LT(rotation_error_deg(*estimate, truth), 1e-6);
}

TEST(EstimateRotation, OfParallelVectorsIsNotUnique) {
  Points a(3, 3);
  a << 1, 2, -3, 0, 0, 0, 0, 0, 0;
  EXPECT_FALSE(estimate_rotation(a, a));
  EXPECT_FALSE(estimate_rotation(Points::Zero(3, 4), Points::Zero(3, 4)));
  EXPECT_FALSE(estimate_rotation(Points(3, 0), Points(3, 0)));
}

TEST(EstimateRotation, RefusesDifferentNumbersOfVectors) {
  EXPECT_THROW(estimate_rotation(Points::Zero(3, 2), Points::Zero(3, 3)), std::invalid_argument);
}

TEST(EstimateTranslation, IsTheMeanWeightedByTheInverseSquareOfTheBounds) {
  Points measurements(3, 2);
  measurements << 0, 5, 0, 0, 1, 1;
  const Eigen::Vector3d t = estimate_translation(measurements, Eigen::Array2d(1, 2));
  EXPECT_LT((t - Eigen::Vector3d(1, 0, 1)).norm(), 1e-15);
}

TEST(MeasureSpread, GivesTheReachFromCentroidAndLine) {
  Points points(3, 4);
  points << -2, 2, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0;
  const auto alike = [](Index count) { return Eigen::ArrayXd::Constant(count, 0.1); };
  const Spread spread = measure_spread(points, {0, 1, 2, 3}, alike(4));
  EXPECT_NEAR(spread.from_centroid.maxCoeff(), 2, 1e-12);
  EXPECT_NEAR(spread.from_line.maxCoeff(), 1, 1e-12);
  EXPECT_NEAR(spread.radius, std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(measure_spread(points, {0, 1}, alike(2)).from_line.maxCoeff(), 0, 1e-12);
  EXPECT_EQ(measure_spread(points, {2}, alike(1)).from_centroid.maxCoeff(), 0);
  EXPECT_EQ(measure_spread(points, {}, alike(0)).from_centroid.size(), 0);
}

TEST(MeasureSpread, IsNotMovedByALoosePoint) {
  Points points(3, 4);
  points << -1, 1, 0, 50, 0, 0, 0, 70, 0, 0, 0, 0;
  const Spread spread = measure_spread(points, {0, 1, 2, 3}, Eigen::Array4d(1e-3, 1e-3, 1e-3, 100));
  EXPECT_LT(spread.from_line.head(3).maxCoeff(), 1e-6);
  EXPECT_NEAR(spread.from_centroid[0], 1, 1e-6);
  EXPECT_NEAR(spread.from_line[3], 70, 1e-3);
}

}  // namespace
}  // namespace gmcr::estimation
