#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

/// Three instances of one source in a target, 30, 22 and 16 matches, mixed with 32 random ones.
struct Scene {
  Points source, target;
  std::vector<Similarity> poses;
  std::vector<int> instance;  ///< of each match; -1: of none

  Options options() const {
    Options options;
    options.noise_bound = 0.01;
    return options;
  }
};

constexpr Index kSizes[] = {30, 22, 16};

Scene three_instances(std::uint64_t seed) {
  testing::RandomGeometry random(seed);
  Scene scene;
  for (int k = 0; k < 3; ++k) scene.poses.push_back(random.similarity(1, 1, 3));
  scene.source = random.in_cube(100);
  scene.target.resize(3, 100);
  scene.instance.assign(100, -1);
  Index next = 0;
  const auto place = [&] { return next++ * 37 % 100; };
  for (int k = 0; k < 3; ++k) {
    const auto pose = static_cast<std::size_t>(k);
    for (Index m = 0; m < kSizes[k]; ++m) {
      const Index i = place();
      scene.target.col(i) = scene.poses[pose] * scene.source.col(i) + random.in_ball(0.01);
      scene.instance[static_cast<std::size_t>(i)] = k;
    }
  }
  while (next < 100) scene.target.col(place()) = 3 * random.in_cube(1);
  return scene;
}

void expect_all_found(const Scene& scene, const Options& options,
                      const std::vector<double>& bounds) {
  const std::vector<Result> found = register_instances(scene.source, scene.target, options);
  ASSERT_EQ(found.size(), 3u);
  std::vector<int> times_used(100, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Result& result = found[k];
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_LT(mean_point_error(result.target_from_source, scene.poses[k], scene.source), 0.02);
    EXPECT_GE(result.certificate.lower, kSizes[k] - 1);
    EXPECT_TRUE(std::is_sorted(result.inliers.begin(), result.inliers.end()));
    if (k > 0) {
      EXPECT_LT(result.inliers.size(), found[k - 1].inliers.size());
    }
    for (Index i = 0; i < 100; ++i) {
      const bool is_inlier = std::binary_search(result.inliers.begin(), result.inliers.end(), i);
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Vector3d image = result.target_from_source * scene.source.col(i);
      const bool is_within = (scene.target.col(i) - image).norm() <= bounds[at];
      // exactly what is within the bound and is left
      EXPECT_EQ(is_inlier, is_within && times_used[at] == 0) << i;
    }
    for (const std::vector<Index>* used : {&result.inliers, &result.certificate.inliers}) {
      for (const Index i : *used) times_used[static_cast<std::size_t>(i)] = 1;
    }
    EXPECT_EQ(result.certificate.lower, static_cast<Index>(result.certificate.inliers.size()));
    EXPECT_GE(result.certificate.upper, result.certificate.lower);
  }
}

TEST(RegisterInstances, FindsAllOfThemLargestFirst) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = three_instances(seed);
    Options options = scene.options();
    expect_all_found(scene, options, std::vector<double>(100, 0.01));
    options.noise_bound = 0.0125;
    expect_all_found(scene, options, std::vector<double>(100, 0.0125));
    options = scene.options();
    options.scale_mode = ScaleMode::Estimated;
    options.scale_range = ScaleRange{0.5, 2};
    expect_all_found(scene, options, std::vector<double>(100, 0.01));
  }
}

TEST(RegisterInstances, TakesABoundForEachCorrespondence) {
  Scene scene = three_instances(5);
  testing::RandomGeometry random(6);
  Options options;
  options.noise_bounds.assign(100, 0.01);
  for (std::size_t i = 0; i < 100; ++i) {
    // the matches of the second instance are worse, and their bounds say so
    if (scene.instance[i] != 1) continue;
    const auto column = static_cast<Index>(i);
    scene.target.col(column) = scene.poses[1] * scene.source.col(column) + 0.03 * random.unit();
    options.noise_bounds[i] = 0.04;
  }
  expect_all_found(scene, options, options.noise_bounds);
}

TEST(RegisterInstances, EndsWhereTheInstanceOptionsSay) {
  const Scene scene = three_instances(7);
  const auto count = [&](const InstanceOptions& instances) {
    return register_instances(scene.source, scene.target, scene.options(), instances).size();
  };
  EXPECT_EQ(count({}), 3u);
  EXPECT_EQ(count({.max_instances = 1}), 1u);
  EXPECT_EQ(count({.max_instances = 2}), 2u);
  EXPECT_EQ(count({.min_instance_inliers = 20}), 2u);
  EXPECT_EQ(count({.min_instance_inliers = 25}), 1u);
  EXPECT_EQ(count({.min_instance_inliers = 40}), 1u);  // the first whatever it holds
  EXPECT_EQ(count({.min_instance_share = 0.6}), 2u);
  EXPECT_EQ(count({.min_instance_share = 0.9}), 1u);
}

TEST(RegisterInstances, NumbersTheInliersOfAlternativesAsTheCallerDoes) {
  const Scene scene = three_instances(8);
  Options options = scene.options();
  options.num_hypotheses = 2;
  const auto found = register_instances(scene.source, scene.target, options, {.max_instances = 2});
  ASSERT_EQ(found.size(), 2u);
  // of what the first left, the second is the best and the third the next
  ASSERT_EQ(found[1].alternatives.size(), 1u);
  const auto& inliers = found[1].alternatives[0].inliers;
  EXPECT_GE(inliers.size(), 13u);
  EXPECT_GE(
      std::count_if(inliers.begin(), inliers.end(),
                    [&](Index i) { return scene.instance[static_cast<std::size_t>(i)] == 2; }),
      13);
}

TEST(RegisterInstances, OfThreeOrFewerIsOneResultWithItsStatus) {
  for (Index count = 0; count <= 3; ++count) {
    const auto problem = testing::random_problem(9, count, 0);
    const auto found = register_instances(problem.source, problem.target, problem.options());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].status, count < 3 ? Status::TooFewCorrespondences : Status::Ok);
    EXPECT_EQ(static_cast<Index>(found[0].inliers.size()), count < 3 ? 0 : 3);
  }
}

TEST(RegisterInstances, EndsWhereNothingIsLeft) {
  const auto problem = testing::random_problem(10, 20, 0);
  Options options = problem.options();
  options.noise_bound = 0.02;
  const auto found = register_instances(problem.source, problem.target, options);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].inliers.size(), 20u);
}

TEST(RegisterInstances, NamesTheOptionThatIsOutOfRange) {
  const std::vector<std::pair<const char*, InstanceOptions>> cases = {
      {"max_instances", {.max_instances = 0}},
      {"max_instances", {.max_instances = -1}},
      {"min_instance_inliers", {.min_instance_inliers = 2}},
      {"min_instance_share", {.min_instance_share = -0.1}},
      {"min_instance_share", {.min_instance_share = 1.1}},
      {"min_instance_share", {.min_instance_share = std::nan("")}},
  };
  const auto problem = testing::random_problem(11, 10, 0);
  for (const auto& [field, instances] : cases) {
    try {
      register_instances(problem.source, problem.target, problem.options(), instances);
      FAIL() << field;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(field) + ":", 0), 0u) << error.what();
    }
  }
  EXPECT_THROW(register_instances(problem.source, problem.target.leftCols(9), problem.options()),
               std::invalid_argument);
  EXPECT_THROW(register_instances(problem.source, problem.target, Options{}),
               std::invalid_argument);
}

TEST(RegisterInstances, SaysWhenTheTimeEndedTheSearch) {
  const Scene scene = three_instances(12);
  Options options = scene.options();
  options.time_limit = 1e-7;
  const auto found = register_instances(scene.source, scene.target, options);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].diagnostics.limits_hit.empty());
  EXPECT_NE(found[0].diagnostics.limits_hit.back().sentence.find("instances"), std::string::npos);
}

TEST(RegisterInstances, ShareTheTime) {
  // chance fits of a loose bound: there is always one more, and none is proven within the time
  SyntheticOptions synthetic;
  synthetic.num_correspondences = 400;
  synthetic.outlier_rate = 0.9;
  synthetic.noise_bound = 0.15;
  const SyntheticProblem problem = make_synthetic(synthetic);
  Options options;
  options.noise_bound = problem.noise_bound;
  options.scale_mode = ScaleMode::Estimated;
  options.time_limit = 0.5;
  const auto begin = std::chrono::steady_clock::now();
  const auto found =
      register_instances(problem.source, problem.target, options,
                         {.max_instances = 8, .min_instance_inliers = 3, .min_instance_share = 0});
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(found.size(), 8u);
  EXPECT_LT(wall.count(), 2);  // each with its own 0.5 s would take 4
}

TEST(RegisterInstances, EndsWhenAllMatchesAreUsedUp) {
  const auto problem = testing::random_problem(5, 20, 0);
  Options options = problem.options();
  options.noise_bound = 0;
  options.noise_bounds.assign(20, 0.01);
  const std::vector<Result> found = register_instances(problem.source, problem.target, options);
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found.front().certificate.lower, 20);
}

}  // namespace
}  // namespace gmcr::registration
