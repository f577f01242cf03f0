#include "problem/objective/distinct_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "problem/correspondences.hpp"
#include "problem/scale_buckets.hpp"
#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

constexpr std::size_t kEnough = 1 << 20;
const ScaleBuckets kBuckets(1.1);

Eigen::ArrayXd weights_of(const Correspondences& correspondences, double scale) {
  const DistinctEvidence evidence(correspondences.source, correspondences.target,
                                  correspondences.bounds, kEnough, kBuckets);
  Eigen::ArrayXd weights(correspondences.size());
  for (Index i = 0; i < weights.size(); ++i) weights[i] = evidence.weight(i, scale);
  return weights;
}

TEST(DistinctEvidence, CountsTheCopiesWithinTheirRadius) {
  testing::RandomGeometry random(1);
  Correspondences c{random.in_cube(80), random.in_cube(80), Eigen::ArrayXd(80)};
  for (double& bound : c.bounds) bound = random.uniform(0.02, 0.15);
  c.source.col(7) = c.source.col(3);
  for (const double scale : {0.05, 0.3, 1.0, 4.0}) {
    const Eigen::ArrayXd weights = weights_of(c, scale);
    for (Index i = 0; i < 80; ++i) {
      int copies = 0;
      for (Index j = 0; j < 80; ++j) {
        const double bound = DistinctEvidence::kCopyRadius * 2 * std::min(c.bounds[i], c.bounds[j]);
        copies += j != i && (c.target.col(j) - c.target.col(i)).norm() <= bound &&
                  kBuckets.centre_of(scale) * (c.source.col(j) - c.source.col(i)).norm() <= bound;
      }
      EXPECT_EQ(weights[i], 1.0 / (1 + copies));
    }
  }
}

TEST(DistinctEvidence, OfACopiedCorrespondenceIsSharedByTheCopies) {
  testing::RandomGeometry random(2);
  Correspondences c{10 * random.in_cube(5), 10 * random.in_cube(5),
                    Eigen::ArrayXd::Constant(5, 1e-3)};
  c.source.col(4) = c.source.col(0);
  c.target.col(4) = c.target.col(0);
  const Eigen::ArrayXd weights = weights_of(c, 1);
  EXPECT_EQ(weights[0] + weights[4], 1);
  EXPECT_EQ(weights.sum(), 4);
}

TEST(DistinctEvidence, SaysWhenItsMemoryDoesNotSufficeAndThenCounts) {
  const Correspondences c{Points::Zero(3, 50), Points::Zero(3, 50), Eigen::ArrayXd::Ones(50)};
  EXPECT_TRUE(DistinctEvidence(c.source, c.target, c.bounds, 50 * 49 * sizeof(double), kBuckets)
                  .complete());
  const DistinctEvidence evidence(c.source, c.target, c.bounds, 50 * 49 * sizeof(double) - 1,
                                  kBuckets);
  EXPECT_FALSE(evidence.complete());
  EXPECT_EQ(evidence.weight(0, 1), 1);
}

TEST(DistinctEvidence, IsTheSameForAnyRangeThatHoldsTheScale) {
  testing::RandomGeometry random(3);
  Correspondences c{random.in_cube(200), random.in_cube(200), Eigen::ArrayXd(200)};
  for (double& bound : c.bounds) bound = random.uniform(0.001, 0.15);
  const DistinctEvidence all(c.source, c.target, c.bounds, kEnough, kBuckets),
      some(c.source, c.target, c.bounds, kEnough, kBuckets, {0.5, 2});
  for (const double scale : {0.5, 0.7, 0.71, 1.0, 1.3, 2.0}) {
    const DistinctEvidence known(c.source, c.target, c.bounds, kEnough, kBuckets, {scale, scale});
    EXPECT_TRUE(known.has_copies());
    for (Index i = 0; i < 200; ++i) {
      EXPECT_EQ(known.weight(i, scale), all.weight(i, scale));
      EXPECT_EQ(some.weight(i, scale), all.weight(i, scale));
    }
  }
}

TEST(DistinctEvidence, DoesNotDependOnScalesOfOneBucket) {
  testing::RandomGeometry random(5);
  const Correspondences c{random.in_cube(100), random.in_cube(100),
                          Eigen::ArrayXd::Constant(100, 0.1)};
  EXPECT_FALSE(DistinctEvidence(c.source, c.target, c.bounds, kEnough, kBuckets, {0.8, 1.5})
                   .depends_on_scale());
  EXPECT_TRUE(DistinctEvidence(c.source, c.target, c.bounds, kEnough, kBuckets, {0.8, 1.6})
                  .depends_on_scale());
}

TEST(DistinctEvidence, OfADistantScaleHasNoCopies) {
  testing::RandomGeometry random(4);
  const Correspondences c{random.in_cube(50), random.in_cube(50),
                          Eigen::ArrayXd::Constant(50, 0.1)};
  EXPECT_TRUE(
      DistinctEvidence(c.source, c.target, c.bounds, kEnough, kBuckets, {0.1, 0.1}).has_copies());
  EXPECT_FALSE(
      DistinctEvidence(c.source, c.target, c.bounds, kEnough, kBuckets, {1e6, 1e6}).has_copies());
}

TEST(DistinctEvidence, OfOneHugeClusterEndsWithItsMemory) {
  const Correspondences c{Points::Zero(3, 20'000), Points::Zero(3, 20'000),
                          Eigen::ArrayXd::Ones(20'000)};
  const DistinctEvidence evidence(c.source, c.target, c.bounds, kEnough, kBuckets, {1, 1});
  EXPECT_FALSE(evidence.complete());
  EXPECT_FALSE(evidence.has_copies());
}

TEST(DistinctEvidence, OfNothingIsComplete) {
  const Correspondences c{Points(3, 0), Points(3, 0), Eigen::ArrayXd(0)};
  EXPECT_TRUE(DistinctEvidence(c.source, c.target, c.bounds, 0, kBuckets).complete());
}

}  // namespace
}  // namespace gmcr::problem
