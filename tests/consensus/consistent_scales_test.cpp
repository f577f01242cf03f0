#include "consensus/consistent_scales.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_geometry.hpp"

namespace gmcr {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Noisy correspondences at the scale 2, each with its own bound.
kernels::CorrespondenceArrays noisy_inliers(std::uint64_t seed, Index count, double offset = 0) {
  testing::RandomGeometry random(seed);
  Points source = random.in_cube(count);
  Points target = 2 * source;
  Eigen::ArrayXd bounds(count);
  for (Index i = 0; i < count; ++i) {
    bounds[i] = random.uniform(0.01, 0.1);
    target.col(i) += random.in_ball(bounds[i]);
  }
  source.array() += offset;
  target.array() -= offset;
  return {source.transpose(), target.transpose(), bounds};
}

ScaleRange brute_force(const kernels::CorrespondenceArrays& c) {
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

TEST(ConsistentScales, AreTheIntersectionOverAllPairs) {
  for (const Index count : {2, 3, 16, 17, 100}) {
    const auto inliers = noisy_inliers(1, count);
    const ScaleRange expected = brute_force(inliers);
    const ScaleRange range = consistent_scales(inliers, 2, 1, Deadline::never());
    EXPECT_NEAR(range.min, expected.min, 1e-12);
    EXPECT_NEAR(range.max, expected.max, 1e-12);
    EXPECT_LT(range.min, 2);
    EXPECT_GT(range.max, 2);
  }
}

TEST(ConsistentScales, AreTheSameBitsForAnyNumberOfThreads) {
  const auto inliers = noisy_inliers(2, 300);
  const ScaleRange one = consistent_scales(inliers, 2, 1, Deadline::never());
  for (const int threads : {2, 7}) {
    const ScaleRange range = consistent_scales(inliers, 2, threads, Deadline::never());
    EXPECT_EQ(range.min, one.min);
    EXPECT_EQ(range.max, one.max);
  }
}

TEST(ConsistentScales, DoNotSeeTheOrigin) {
  const ScaleRange close = consistent_scales(noisy_inliers(3, 50), 2, 1, Deadline::never());
  const ScaleRange far = consistent_scales(noisy_inliers(3, 50, 1e6), 2, 1, Deadline::never());
  EXPECT_NEAR(far.min, close.min, 1e-7);
  EXPECT_NEAR(far.max, close.max, 1e-7);
}

TEST(ConsistentScales, AlwaysContainTheGivenOne) {
  auto inliers = noisy_inliers(4, 20);
  inliers.target = 2 * inliers.source;
  inliers.bounds.setConstant(1e-300);
  const ScaleRange range = consistent_scales(inliers, 2, 1, Deadline::never());
  EXPECT_LE(range.min, 2);
  EXPECT_GE(range.max, 2);
  EXPECT_NEAR(range.max - range.min, 0, 1e-12);
}

TEST(ConsistentScales, OfCoincidentSourcesAreAll) {
  auto inliers = noisy_inliers(5, 4);
  inliers.source.setZero();
  const ScaleRange range = consistent_scales(inliers, 2, 1, Deadline::never());
  EXPECT_EQ(range.min, 0);
  EXPECT_EQ(range.max, kInfinity);
  EXPECT_EQ(consistent_scales(noisy_inliers(5, 0), 2, 1, Deadline::never()).max, kInfinity);
}

TEST(ConsistentScales, AreOnlyWiderWhereTheTimeIsUp) {
  const auto inliers = noisy_inliers(6, 100);
  const ScaleRange all = consistent_scales(inliers, 2, 1, Deadline::never());
  const ScaleRange none = consistent_scales(inliers, 2, 1, Deadline(0));
  EXPECT_LT(none.min, all.min);
  EXPECT_GT(none.max, all.max);
}

}  // namespace
}  // namespace gmcr
