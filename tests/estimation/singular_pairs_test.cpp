#include "estimation/closed_forms/singular_pairs.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "estimation/closed_forms/rotation.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

Eigen::Matrix3d with_values(testing::RandomGeometry& random, const Eigen::Vector3d& values) {
  return random.rotation() * values.asDiagonal() * random.rotation().transpose();
}

TEST(LeadingSingularPairs, AreThoseOfEigensDecomposition) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 500; ++trial) {
    Eigen::Matrix3d matrix = random.in_cube(3);
    if (trial % 5 == 0) matrix.col(2) = matrix.col(0);                       // of rank 2
    if (trial % 7 == 0) matrix = random.unit() * random.unit().transpose();  // of rank 1
    if (trial % 11 == 0) matrix = with_values(random, {2, 2, 1});
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix);
    const SingularPairs pairs = leading_singular_pairs(matrix);
    EXPECT_LT((pairs.values - svd.singularValues().head<2>()).norm(), 1e-14);
    EXPECT_LT((matrix * pairs.right - pairs.left * pairs.values.asDiagonal()).norm(), 1e-14);
    EXPECT_LT((pairs.right.transpose() * pairs.right - Eigen::Matrix2d::Identity()).norm(), 1e-13);
  }
}

TEST(LeadingSingularPairs, HaveTheMagnitudeOfTheMatrix) {
  testing::RandomGeometry random(2);
  for (const double size : {1e-200, 1e-20, 1e20, 1e200}) {
    const Eigen::Matrix3d matrix = with_values(random, {3, 2, 1});
    const SingularPairs pairs = leading_singular_pairs(size * matrix);
    EXPECT_NEAR(pairs.values[0] / size, 3, 1e-13);
    EXPECT_NEAR(pairs.values[1] / size, 2, 1e-13);
  }
}

TEST(LeadingSingularPairs, OfNothingAndOfWhatIsNoNumberAreNone) {
  EXPECT_EQ(leading_singular_pairs(Eigen::Matrix3d::Zero()).values, Eigen::Vector2d::Zero());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rotation_from_covariance(Eigen::Matrix3d::Constant(nan)));
}

TEST(RotationFromCovariance, IsTheBestOneWhateverTheSignOfTheDeterminant) {
  testing::RandomGeometry random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Matrix3d covariance = random.in_cube(3);
    const auto rotation = rotation_from_covariance(covariance);
    ASSERT_TRUE(rotation);
    EXPECT_NEAR(rotation->determinant(), 1, 1e-13);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance);
    const Eigen::Vector3d& values = svd.singularValues();
    const double best = values[0] + values[1] + (covariance.determinant() < 0 ? -1 : 1) * values[2];
    EXPECT_NEAR(rotation->cwiseProduct(covariance).sum(), best, 1e-12);
  }
}

}  // namespace
}  // namespace gmcr::estimation
