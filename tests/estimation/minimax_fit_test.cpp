#include "estimation/fits/minimax_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

/// Correspondences of a planted pose with noise about as large as their bounds.
struct NoisySet {
  Points source, target;
  Eigen::ArrayXd bounds;
  Similarity truth;

  double largest_residual(const Similarity& pose) const {
    const Eigen::ArrayXd residuals = (target - pose.apply(source)).colwise().norm().transpose();
    return (residuals / bounds).maxCoeff();
  }
};

NoisySet noisy_set(std::uint64_t seed, Index count, const ScaleRange& scales) {
  testing::RandomGeometry random(seed);
  NoisySet set;
  set.truth = random.similarity(scales.min, scales.max, 3);
  set.source = random.in_cube(count);
  set.target = set.truth.apply(set.source);
  set.bounds.resize(count);
  for (Index i = 0; i < count; ++i) {
    set.bounds[i] = random.uniform(0.01, 0.05);
    set.target.col(i) += random.in_ball(1.5 * set.bounds[i]);
  }
  return set;
}

RC_GTEST_PROP(MinimaxFit, BoundsTheLargestResidualOfEveryPoseFromBelow, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const ScaleRange scales = *rc::gen::element(ScaleRange{1, 1}, ScaleRange{0.7, 1.6});
  const NoisySet set = noisy_set(seed, *rc::gen::inRange<Index>(3, 25), scales);
  MinimaxFit fit(set.source, set.target, set.bounds, PoseConstraints{scales});
  std::vector<Similarity> poses{set.truth};
  double before = 0;
  for (int step = 0; step < 60; ++step) {
    RC_ASSERT(fit.step());
    RC_ASSERT(fit.lower_bound() >= before);
    before = fit.lower_bound();
    poses.push_back(fit.pose());
    const double largest = set.largest_residual(fit.pose());
    RC_ASSERT(std::abs(fit.residuals().maxCoeff() - largest) <= 1e-9 * (1 + largest));
    RC_ASSERT(fit.pose().scale >= scales.min && fit.pose().scale <= scales.max);
    RC_ASSERT(fit.weights().maxCoeff() == 1);
    RC_ASSERT(fit.weights().minCoeff() > 0);
  }
  testing::RandomGeometry random(seed + 1);
  for (int k = 0; k < 20; ++k) {
    // around the best fit, where the bound is tightest
    Similarity near = fit.pose();
    near.rotation = Eigen::AngleAxisd(random.uniform(0, 0.02), random.unit()) * near.rotation;
    near.translation += random.in_ball(0.01);
    near.scale = std::clamp(near.scale * random.uniform(0.99, 1.01), scales.min, scales.max);
    poses.push_back(near);
    poses.push_back(random.similarity(scales.min, scales.max, 3));
  }
  for (const Similarity& pose : poses) {
    RC_ASSERT(fit.lower_bound() <= set.largest_residual(pose) * (1 + 1e-9));
  }
}

TEST(MinimaxFit, ComesWithinAFewPerCentOfTheLeastLargestResidual) {
  for (const ScaleRange scales : {ScaleRange{1, 1}, ScaleRange{0.7, 1.6}}) {
    int fitted_better = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const NoisySet set = noisy_set(seed, 4 + static_cast<Index>(seed % 20), scales);
      MinimaxFit fit(set.source, set.target, set.bounds, PoseConstraints{scales});
      ASSERT_TRUE(fit.step());
      const double least_squares = fit.residuals().maxCoeff();
      double best = least_squares;
      for (int step = 0; step < 300; ++step) {
        ASSERT_TRUE(fit.step());
        best = std::min(best, fit.residuals().maxCoeff());
      }
      EXPECT_LE(best, 1.03 * fit.lower_bound()) << seed;
      fitted_better += best < 0.95 * least_squares;
    }
    EXPECT_GE(fitted_better, 40);
  }
}

TEST(MinimaxFit, OfAnExactSetIsThePlantedPose) {
  NoisySet set = noisy_set(1, 12, {2, 2});
  set.target = set.truth.apply(set.source);
  MinimaxFit fit(set.source, set.target, set.bounds, PoseConstraints{{0.5, 4}});
  for (int step = 0; step < 10; ++step) ASSERT_TRUE(fit.step());
  EXPECT_LT(set.largest_residual(fit.pose()), 1e-9);
  EXPECT_LT(fit.lower_bound(), 1e-9);
}

TEST(MinimaxFit, ProvesThatNoPoseHoldsAMirroredSet) {
  testing::RandomGeometry random(2);
  const Points source = random.in_cube(6);
  Points target = source;
  target.row(1) *= -1;
  MinimaxFit fit(source, target, Eigen::ArrayXd::Constant(6, 0.01), PoseConstraints{{1, 1}});
  ASSERT_TRUE(fit.step());
  EXPECT_GT(fit.lower_bound(), 1);
}

TEST(MinimaxFit, NeverExcludesAnExactSetOfNearlyCollinearPoints) {
  // a roll about the line that the closed form cannot see
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    testing::RandomGeometry random(seed);
    Points source = random.in_cube(7);
    source.row(0) *= 1000;
    source.bottomRows<2>() *= 1e-3;
    Similarity roll;
    roll.rotation = Eigen::AngleAxisd(3, Eigen::Vector3d::UnitX()).matrix();
    MinimaxFit fit(source, roll.apply(source), Eigen::ArrayXd::Constant(7, 1e-4),
                   PoseConstraints{{1, 1}});
    for (int step = 0; step < 30; ++step) fit.step();
    EXPECT_LE(fit.lower_bound(), 1) << seed;
  }
}

TEST(MinimaxFit, GoesOnWithoutAPointThatIsLeftOut) {
  NoisySet set = noisy_set(3, 9, {1, 1});
  set.target = set.truth.apply(set.source);
  set.target.col(4) += Eigen::Vector3d(1, 0, 0);
  MinimaxFit fit(set.source, set.target, set.bounds, PoseConstraints{{1, 1}});
  for (int step = 0; step < 20; ++step) ASSERT_TRUE(fit.step());
  EXPECT_GT(fit.lower_bound(), 1);
  const double weight_of_last = fit.weights()[8];
  fit.leave_out(4);
  EXPECT_EQ(fit.lower_bound(), 0);
  ASSERT_EQ(fit.weights().size(), 8);
  EXPECT_EQ(fit.weights()[7], weight_of_last);
  ASSERT_TRUE(fit.step());
  EXPECT_LT(fit.residuals().maxCoeff(), 1e-9);
  EXPECT_LT((fit.pose().rotation - set.truth.rotation).norm(), 1e-9);
}

TEST(MinimaxFit, OfFewerThanThreePointsHasNoStep) {
  for (const Index count : {0, 1, 2}) {
    MinimaxFit fit(Points::Random(3, count), Points::Random(3, count), Eigen::ArrayXd::Ones(count),
                   PoseConstraints{{1, 1}});
    EXPECT_FALSE(fit.step());
    EXPECT_EQ(fit.lower_bound(), 0);
  }
}

}  // namespace
}  // namespace gmcr::estimation
