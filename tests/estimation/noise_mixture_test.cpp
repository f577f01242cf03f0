#include "estimation/uncertainty/noise_mixture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

using Tails = NoiseMixture::Tails;

/// Squared length of a vector of Student's t distribution, or of a normal one for nu = 0.
double drawn_square(testing::RandomGeometry& random, double sigma, int nu) {
  double square = 0, divisor = 0;
  for (int axis = 0; axis < 3; ++axis) square += std::pow(sigma * random.normal(), 2);
  for (int k = 0; k < nu; ++k) divisor += std::pow(random.normal(), 2) / nu;
  return nu > 0 ? square / divisor : square;
}

/// Residuals of right matches, and of wrong ones spread evenly, within the window.
Eigen::ArrayXd drawn(std::uint64_t seed, int num_right, int num_wrong, double sigma, int nu) {
  testing::RandomGeometry random(seed);
  std::vector<double> squares;
  const double limit = NoiseMixture::kWindow * NoiseMixture::kWindow;
  while (static_cast<int>(squares.size()) < num_right) {
    const double square = drawn_square(random, sigma, nu);
    if (square <= limit) squares.push_back(square);
  }
  for (int k = 0; k < num_wrong; ++k) {
    squares.push_back(limit * std::pow(random.uniform(0, 1), 2.0 / 3));
  }
  return Eigen::Map<Eigen::ArrayXd>(squares.data(), static_cast<Index>(squares.size()));
}

TEST(NoiseMixture, FindsTheNoiseAndTheShare) {
  for (const double sigma : {0.15, 0.3, 0.6}) {
    const NoiseMixture noise = fit_noise(drawn(1, 4000, 2000, sigma, 0));
    EXPECT_NEAR(std::sqrt(noise.variance()), sigma, 0.03 * sigma);
    EXPECT_NEAR(noise.share(), 2.0 / 3, 0.03);
    EXPECT_GT(noise.information(), 0.95);
  }
}

TEST(NoiseMixture, SeesHeavyTails) {
  int heavy = 0, light = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    heavy += fit_noise(drawn(seed, 300, 100, 0.2, 3)).information() < 0.8;
    light += fit_noise(drawn(seed, 300, 100, 0.3, 0)).information() > 0.8;
  }
  EXPECT_GE(heavy, 18);
  EXPECT_GE(light, 18);
}

TEST(NoiseMixture, HasADensityOfIntegralOne) {
  // the odds of right against wrong, with shares of one half, are the ratio of the densities
  for (const Tails tails : {Tails::Light, Tails::Heavy}) {
    Eigen::ArrayXd start(4);
    start << 0.01, 0.02, 4, 5;
    NoiseMixture noise(tails, start);
    ASSERT_EQ(noise.share(), 0.5);
    constexpr Index kSteps = 200000;
    constexpr double kEnd = 40;
    const double step = kEnd / kSteps;
    const Eigen::ArrayXd radii = (Eigen::ArrayXd::LinSpaced(kSteps, 0, kSteps - 1) + 0.5) * step;
    const Eigen::ArrayXd right = noise.right(radii.square());
    const double volume = 4 * std::numbers::pi / 3 * std::pow(NoiseMixture::kWindow, 3);
    const double integral =
        (right / (1 - right) / volume * 4 * std::numbers::pi * radii.square()).sum() * step;
    EXPECT_NEAR(integral, 1, 1e-3);
  }
}

TEST(NoiseMixture, TakesFarResidualsForWrong) {
  const NoiseMixture noise = fit_noise(drawn(3, 500, 300, 0.2, 0));
  Eigen::ArrayXd squares(3);
  squares << 0, 0.2 * 0.2, 4;
  const Eigen::ArrayXd right = noise.right(squares), weights = noise.weights(squares);
  EXPECT_GT(right[0], 0.9);
  EXPECT_GT(right[1], 0.9);
  EXPECT_LT(right[2], 0.01);
  EXPECT_GT(weights[0], weights[1]);
}

TEST(NoiseMixture, RaisesTheLikelihoodStepByStep) {
  const Eigen::ArrayXd squares = drawn(4, 200, 200, 0.3, 3);
  for (const Tails tails : {Tails::Light, Tails::Heavy}) {
    NoiseMixture noise(tails, squares);
    double before = noise.log_likelihood(squares);
    for (int k = 0; k < 30; ++k) {
      noise.update(noise.right(squares), noise.weights(squares), squares);
      const double after = noise.log_likelihood(squares);
      EXPECT_GE(after, before - 1e-9);
      before = after;
    }
  }
}

TEST(NoiseMixture, OfExactMatchesStaysFinite) {
  for (const Index count : {0, 1, 3, 100}) {
    const NoiseMixture noise = fit_noise(Eigen::ArrayXd::Zero(count));
    EXPECT_GT(noise.variance(), 0);
    EXPECT_TRUE((noise.right(Eigen::ArrayXd::Zero(count)) > 0.9).all());
  }
}

}  // namespace
}  // namespace gmcr::estimation
