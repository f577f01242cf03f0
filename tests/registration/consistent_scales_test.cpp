#include "registration/judgement/consistent_scales.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_geometry.hpp"

namespace gmcr::registration {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kScale = 2;

/// Noisy correspondences at the scale kScale, each with its own bound.
geometry::CorrespondenceArrays noisy_inliers(std::uint64_t seed, Index count, double offset = 0) {
  testing::RandomGeometry random(seed);
  Points source = random.in_cube(count);
  Points target = kScale * source;
  Eigen::ArrayXd bounds(count);
  for (Index i = 0; i < count; ++i) {
    bounds[i] = random.uniform(0.01, 0.1);
    target.col(i) += random.in_ball(bounds[i]);
  }
  source.array() += offset;
  target.array() -= offset;
  return {source.transpose(), target.transpose(), bounds};
}

ScaleRange brute_force(const geometry::CorrespondenceArrays& c) {
  ScaleRange range{0, kInfinity};
  for (Index i = 0; i < c.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      const double a = (c.source.row(i) - c.source.row(j)).norm();
      const double b = (c.target.row(i) - c.target.row(j)).norm();
      range.min = std::max(range.min, (b - c.bounds[i] - c.bounds[j]) / a);
      range.max = std::min(range.max, (b + c.bounds[i] + c.bounds[j]) / a);
    }
  }
  return range;
}

ScaleRange consistent(const geometry::CorrespondenceArrays& inliers, int num_threads = 1,
                      const parallel::Deadline& deadline = parallel::Deadline::never()) {
  // offsets of the clouds are opposite; noise has mean near 0
  const Eigen::RowVector3d offset =
      inliers.size() == 0 ? Eigen::RowVector3d::Zero().eval()
                          : Eigen::RowVector3d::Constant(std::round(inliers.source.mean()));
  const Eigen::MatrixX3d a = inliers.source.rowwise() - offset;
  const Eigen::MatrixX3d b = inliers.target.rowwise() + offset;
  const Eigen::ArrayXd residuals = (b - kScale * a).rowwise().norm();
  return consistent_scales(inliers, residuals, kScale, num_threads, deadline);
}

TEST(ConsistentScales, AreTheIntersectionOverAllPairs) {
  for (const Index count : {2, 3, 33, 97, 300}) {
    const auto inliers = noisy_inliers(1, count);
    const ScaleRange expected = brute_force(inliers);
    const ScaleRange range = consistent(inliers);
    EXPECT_NEAR(range.min, expected.min, 1e-12);
    EXPECT_NEAR(range.max, expected.max, 1e-12);
    EXPECT_LT(range.min, 2);
    EXPECT_GT(range.max, 2);
  }
}

TEST(ConsistentScales, OfExactCorrespondencesAreThoseOfTheLongestPair) {
  auto inliers = noisy_inliers(7, 200);
  inliers.target = kScale * inliers.source;
  inliers.bounds.setConstant(0.1);
  const ScaleRange expected = brute_force(inliers), range = consistent(inliers);
  EXPECT_NEAR(range.min, expected.min, 1e-12);
  EXPECT_NEAR(range.max, expected.max, 1e-12);
}

TEST(ConsistentScales, AreTheSameBitsForAnyNumberOfThreads) {
  const auto inliers = noisy_inliers(2, 300);
  const ScaleRange one = consistent(inliers);
  for (const int threads : {2, 7}) {
    const ScaleRange range = consistent(inliers, threads);
    EXPECT_EQ(range.min, one.min);
    EXPECT_EQ(range.max, one.max);
  }
}

TEST(ConsistentScales, DoNotSeeTheOrigin) {
  const ScaleRange close = consistent(noisy_inliers(3, 50));
  const ScaleRange far = consistent(noisy_inliers(3, 50, 1e6));
  EXPECT_NEAR(far.min, close.min, 1e-7);
  EXPECT_NEAR(far.max, close.max, 1e-7);
}

TEST(ConsistentScales, AlwaysContainTheGivenOne) {
  auto inliers = noisy_inliers(4, 20);
  inliers.target = 2 * inliers.source;
  inliers.bounds.setConstant(1e-300);
  const ScaleRange range = consistent(inliers);
  EXPECT_LE(range.min, 2);
  EXPECT_GE(range.max, 2);
  EXPECT_NEAR(range.max - range.min, 0, 1e-12);
}

TEST(ConsistentScales, OfCoincidentSourcesAreAll) {
  auto inliers = noisy_inliers(5, 4);
  inliers.source.setZero();
  const ScaleRange range = consistent(inliers);
  EXPECT_EQ(range.min, 0);
  EXPECT_EQ(range.max, kInfinity);
  EXPECT_EQ(consistent(noisy_inliers(5, 0)).max, kInfinity);
}

TEST(ConsistentScales, AreOnlyWiderWhereTheTimeIsUp) {
  const auto inliers = noisy_inliers(6, 100);
  const ScaleRange all = consistent(inliers);
  const ScaleRange none = consistent(inliers, 1, parallel::Deadline(0));
  EXPECT_LT(none.min, all.min);
  EXPECT_GT(none.max, all.max);
}

}  // namespace
}  // namespace gmcr::registration
