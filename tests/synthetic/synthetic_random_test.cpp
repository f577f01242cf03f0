#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "synthetic/random.hpp"

namespace gmcr::synthetic {
namespace {

TEST(Random, OfSeedZeroStartsWithTheEnginesFirstBits) {
  // 2947667278772165694 is the first output that the C++ standard's engine gives for seed 0.
  Random random(0);
  EXPECT_EQ(random.uniform(), static_cast<double>(2947667278772165694ull >> 11) * 0x1.0p-53);
}

TEST(Random, UniformHasTheMeanAndVarianceOfTheUnitInterval) {
  Random random(1);
  double sum = 0;
  double squares = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.uniform();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 0.01);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
  Random random(2);
  double sum = 0;
  double squares = 0;
  int beyond_two_sigma = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
    beyond_two_sigma += std::abs(value) > 2;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.03);
  EXPECT_NEAR(squares / kDraws, 1, 0.03);
  EXPECT_NEAR(beyond_two_sigma / double{kDraws}, 0.0455, 0.007);
}

TEST(Random, BallIsFilledEvenly) {
  Random random(3);
  int inner = 0;
  constexpr int kDraws = 8000;
  for (int i = 0; i < kDraws; ++i) {
    const double norm = random.in_ball(2).norm();
    ASSERT_LE(norm, 2);
    inner += norm <= 1;
  }
  EXPECT_NEAR(inner / double{kDraws}, 1.0 / 8, 0.02);
}

TEST(Random, RotationsAverageToZero) {
  Random random(4);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  constexpr int kDraws = 8000;
  for (int i = 0; i < kDraws; ++i) sum += random.rotation();
  EXPECT_LT((sum / kDraws).cwiseAbs().maxCoeff(), 0.03);
}

RC_GTEST_PROP(Random, RotationsAreProperAndDirectionsAreUnit, (std::uint64_t seed)) {
  Random random(seed);
  const Eigen::Matrix3d rotation = random.rotation();
  RC_ASSERT((rotation * rotation.transpose()).isIdentity(1e-12));
  RC_ASSERT(std::abs(rotation.determinant() - 1) < 1e-12);
  RC_ASSERT(std::abs(random.unit_vector().norm() - 1) < 1e-12);
}

RC_GTEST_PROP(Random, SampleHasDifferentIndicesInRange, (std::uint64_t seed)) {
  const Index total = *rc::gen::inRange<Index>(0, 50);
  const Index count = *rc::gen::inRange<Index>(0, total + 1);
  std::vector<Index> sample = Random(seed).sample(count, total);
  RC_ASSERT(std::ssize(sample) == count);
  std::sort(sample.begin(), sample.end());
  RC_ASSERT(std::adjacent_find(sample.begin(), sample.end()) == sample.end());
  const bool in_range = sample.empty() || (sample.front() >= 0 && sample.back() < total);
  RC_ASSERT(in_range);
}

TEST(Random, IndexReachesEveryValueAboutEquallyOften) {
  Random random(5);
  std::vector<int> counts(7, 0);
  for (int i = 0; i < 7000; ++i) ++counts[static_cast<std::size_t>(random.index(7))];
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace gmcr::synthetic
