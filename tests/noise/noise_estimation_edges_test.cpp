#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "noise/unknown_noise.hpp"
#include "problems.hpp"

namespace gmcr::noise {
namespace {

using testing::unknown_noise;
using testing::unknown_noise_and_scale;

TEST(NoiseEstimation, OfRandomCorrespondencesSaysThatChanceExplainsThem) {
  testing::RandomGeometry random(3);
  for (const Index count : {5, 20, 200}) {
    for (int trial = 0; trial < 5; ++trial) {
      const Points source = random.in_cube(count), target = random.in_cube(count);
      const Result result = register_correspondences(source, target, unknown_noise());
      EXPECT_EQ(result.status, Status::NoConsensus);
      EXPECT_NE(result.status_reason.find("chance"), std::string::npos);
      EXPECT_TRUE(result.inliers.empty());
      ASSERT_TRUE(result.noise_estimate);
      EXPECT_GE(result.noise_estimate->log10_false_alarms, 0);
      EXPECT_GT(result.noise_estimate->noise_bound, 0);
    }
  }
}

TEST(NoiseEstimation, OfExactDataIsTheRoundingOfTheCoordinates) {
  auto problem = testing::random_problem(4, 20, 40);
  problem.target.leftCols(20) = problem.truth.apply(problem.source.leftCols(20));
  const Result result = register_correspondences(problem.source, problem.target, unknown_noise());
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_EQ(result.inliers.size(), 20u);
  EXPECT_GT(result.noise_estimate->noise_bound, 0);
  EXPECT_LT(result.noise_estimate->noise_bound, 1e-12);
}

TEST(NoiseEstimation, OfAFewExactCorrespondencesIsSure) {
  for (const Index count : {4, 5}) {
    auto problem = testing::random_problem(5, count, 0);
    problem.target = problem.truth.apply(problem.source);
    const Result result = register_correspondences(problem.source, problem.target, unknown_noise());
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_EQ(result.inliers.size(), static_cast<std::size_t>(count));
  }
}

TEST(NoiseEstimation, OfThreeCorrespondencesProvesNothing) {
  const auto problem = testing::random_problem(6, 3, 0);
  for (const Index count : {0, 1, 2}) {
    const Result result = register_correspondences(problem.source.leftCols(count),
                                                   problem.target.leftCols(count), unknown_noise());
    EXPECT_EQ(result.status, Status::TooFewCorrespondences);
    EXPECT_FALSE(result.noise_estimate);
  }
  const Result result = register_correspondences(problem.source, problem.target, unknown_noise());
  EXPECT_EQ(result.status, Status::NoConsensus);
  EXPECT_EQ(result.noise_estimate->log10_false_alarms, 0);
}

TEST(NoiseEstimation, CountsARepeatedCorrespondenceOnce) {
  const auto problem = testing::random_problem(7, 30, 60);
  const Result once = register_correspondences(problem.source, problem.target, unknown_noise());
  const Points source = problem.source.replicate<1, 3>(), target = problem.target.replicate<1, 3>();
  const Result thrice = register_correspondences(source, target, unknown_noise());
  EXPECT_EQ(thrice.noise_estimate->noise_bound, once.noise_estimate->noise_bound);
  EXPECT_EQ(thrice.noise_estimate->log10_false_alarms, once.noise_estimate->log10_false_alarms);
  EXPECT_EQ(thrice.inliers.size(), 3 * once.inliers.size());
}

TEST(NoiseEstimation, OfCoincidentPointsFindsNothing) {
  const Points same = Points::Constant(3, 20, 4.0);
  const Result one_correspondence = register_correspondences(same, same, unknown_noise());
  EXPECT_EQ(one_correspondence.status, Status::NoConsensus);
  EXPECT_FALSE(one_correspondence.noise_estimate);
  testing::RandomGeometry random(8);
  for (const Options& options : {unknown_noise(), unknown_noise_and_scale()}) {
    const Result one_target = register_correspondences(random.in_cube(20), same, options);
    EXPECT_EQ(one_target.status, Status::NoConsensus);
    EXPECT_GT(one_target.noise_estimate->noise_bound, 0);
    const Points zero = Points::Zero(3, 20);
    const Result at_origin = register_correspondences(random.in_cube(20), zero, options);
    EXPECT_EQ(at_origin.status, Status::NoConsensus);
    EXPECT_GT(at_origin.noise_estimate->noise_bound, 0);
  }
}

TEST(NoiseEstimation, DoesNotDependOnTheOrder) {
  const auto problem = testing::random_problem(9, 60, 240);
  const Index n = problem.source.cols();
  std::vector<Index> order;
  for (Index k = 0; k < n; ++k) order.push_back(k * 7 % n);  // 7 and 300 have no common divisor
  Options options;
  options.noise_mode = NoiseMode::Estimated;
  const Result one = register_correspondences(problem.source, problem.target, options);
  const Result other = register_correspondences(problem.source(Eigen::all, order),
                                                problem.target(Eigen::all, order), options);
  ASSERT_TRUE(one.noise_estimate && other.noise_estimate);
  EXPECT_EQ(one.noise_estimate->noise_bound, other.noise_estimate->noise_bound);
  EXPECT_EQ(one.noise_estimate->log10_false_alarms, other.noise_estimate->log10_false_alarms);
  std::vector<Index> inliers;
  for (const Index i : other.inliers) inliers.push_back(order[static_cast<std::size_t>(i)]);
  std::sort(inliers.begin(), inliers.end());
  EXPECT_EQ(inliers, one.inliers);
}

TEST(NoiseEstimation, DoesNotSeeAFewFarMatches) {
  auto problem = testing::random_problem(10, 60, 40);
  problem.source.rightCols(5).setConstant(3.4e38);
  Options options;
  options.noise_mode = NoiseMode::Estimated;
  const Result result = register_correspondences(problem.source, problem.target, options);
  ASSERT_TRUE(result.noise_estimate);
  EXPECT_LT(result.noise_estimate->noise_bound, 0.02);
  EXPECT_GE(result.inliers.size(), 55u);
}

TEST(NoiseEstimation, DoesNotSeeThatFarMatchesAgreeToTheirLastDigit) {
  for (const Index num_far : {8, 20}) {
    auto problem = testing::random_problem(11, 40, 160);
    problem.target.rightCols(num_far).setConstant(3.4028234663852886e38);
    Options options;
    options.noise_mode = NoiseMode::Estimated;
    const Result result = register_correspondences(problem.source, problem.target, options);
    ASSERT_TRUE(result.noise_estimate);
    EXPECT_GT(result.noise_estimate->noise_bound, 1e-4);
    EXPECT_LT(result.noise_estimate->noise_bound, 0.02);
    EXPECT_GE(result.inliers.size(), 38u);
  }
}

}  // namespace
}  // namespace gmcr::noise
