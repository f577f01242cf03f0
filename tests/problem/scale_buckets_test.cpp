#include "problem/scale_buckets.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gmcr::problem {
namespace {

using Limits = std::numeric_limits<double>;

TEST(ScaleBuckets, HoldTheScalesNearestToAPowerOfTwo) {
  const ScaleBuckets buckets(1);
  EXPECT_EQ(buckets.centre_of(1), 1);
  EXPECT_EQ(buckets.centre_of(1.414), 1);
  EXPECT_EQ(buckets.centre_of(1.415), 2);
  EXPECT_EQ(buckets.centre_of(0.7072), 1);
  EXPECT_EQ(buckets.centre_of(0.7071), 0.5);
  EXPECT_EQ(buckets.centre_of(1e-3), 1.0 / 1024);
  EXPECT_EQ(buckets.centre_of(0), 0);
  EXPECT_EQ(buckets.centre_of(Limits::infinity()), Limits::infinity());
}

TEST(ScaleBuckets, AscendWithTheScaleAsFarAsThereAreDoubles) {
  for (const double centre : {1e-300, 1e-10, 1.0, 1e10, 1e300}) {
    double below = 0;
    for (int exponent = -1074; exponent < 1024; ++exponent) {
      const double at = ScaleBuckets(centre).centre_of(std::ldexp(1.3, exponent));
      EXPECT_GE(at, below);
      below = at;
    }
  }
}

TEST(ScaleBuckets, MoveWithTheirCentre) {
  for (const double centre : {1e-3, 0.3, 1.0, 7.0, 1e6}) {
    const ScaleBuckets buckets(centre);
    for (const double scale : {1e-4, 0.4, 0.7, 1.0, 1.3, 1.5, 100.0}) {
      EXPECT_EQ(buckets.centre_of(centre * scale), centre * ScaleBuckets(1).centre_of(scale));
    }
  }
}

TEST(ScaleBuckets, EndAtEdges) {
  for (const double centre : {0.3, 1.0, 7.0, 1e6}) {
    const ScaleBuckets buckets(centre);
    for (int bucket = -5; bucket <= 5; ++bucket) {
      const double end = buckets.edge(35 * bucket, 35);
      EXPECT_EQ(buckets.centre_of(end), std::ldexp(centre, bucket - 1));
      EXPECT_EQ(buckets.centre_of(end * (1 + 1e-13)), std::ldexp(centre, bucket));
      for (int k = 0; k < 35; ++k) {
        const double ratio =
            buckets.edge(35 * bucket + k + 1, 35) / buckets.edge(35 * bucket + k, 35);
        EXPECT_NEAR(ratio, std::exp2(1.0 / 35), 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace gmcr::problem
