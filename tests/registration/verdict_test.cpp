#include <gtest/gtest.h>

#include "geometry/angles.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::random_problem;

bool says(const Result& result, const std::string& words) {
  return result.verdict_reason.find(words) != std::string::npos;
}

TEST(Verdict, OfManyRightMatchesIsTrusted) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto problem = random_problem(seed, 15, 200);
    for (const auto& options : {problem.options(), problem.options_with_unknown_scale()}) {
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
      EXPECT_LT(result.log10_false_alarms, -6);
      EXPECT_TRUE(says(result, "chance would give this once in 10^"));
    }
  }
}

TEST(Verdict, OfRandomMatchesIsNeverTrusted) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const Index count : {5, 30, 300}) {
      auto problem = random_problem(seed, 0, count);
      problem.noise_bound = 0.05;
      for (const auto& options : {problem.options(), problem.options_with_unknown_scale()}) {
        const Result result = register_correspondences(problem.source, problem.target, options);
        EXPECT_NE(result.verdict, Verdict::Trusted) << seed << " " << count;
        EXPECT_FALSE(result.verdict_reason.empty());
      }
    }
  }
}

TEST(Verdict, SurvivesClustersOfWrongTargets) {
  testing::RandomGeometry random(1);
  for (const int num_clusters : {3, 10}) {
    const Points source = random.in_cube(300);
    Points target = source;
    const Points centers = random.in_cube(num_clusters);
    for (Index i = 30; i < 300; ++i) {
      target.col(i) = centers.col(random.index(num_clusters)) + random.in_ball(0.01);
    }
    Options options;
    options.noise_bound = 0.01;
    EXPECT_EQ(register_correspondences(source, target, options).verdict, Verdict::Trusted);
    options.noise_bound = 0;
    options.noise_mode = NoiseMode::Estimated;
    const Result estimated = register_correspondences(source, target, options);
    EXPECT_EQ(estimated.verdict, Verdict::Trusted) << estimated.verdict_reason;
    EXPECT_GE(estimated.inliers.size(), 30u);
  }
}

TEST(Verdict, NamesLeftHandedData) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    auto problem = random_problem(seed, 200, 50);
    problem.source.row(2) *= -1;
    problem.noise_bound = 0.03;
    for (const auto& options : {problem.options(), problem.options_with_unknown_scale()}) {
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(result.verdict, Verdict::Untrusted) << seed;
      EXPECT_TRUE(says(result, "left-handed")) << result.verdict_reason;
    }
  }
}

TEST(Verdict, TakesAPlaneForNoReflection) {
  testing::RandomGeometry random(3);
  Points source = random.in_cube(60);
  source.row(2).setZero();
  const Similarity truth = random.similarity(1, 1, 1);
  Options options;
  options.noise_bound = 0.01;
  const Result result = register_correspondences(source, truth.apply(source), options);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
}

TEST(Verdict, OfOneThingSaidOftenIsNotTrusted) {
  // two spots of 100 matches each, wide as the bound, and some between: the pose is determined, but
  // by few distinct matches
  testing::RandomGeometry random(4);
  const Points centers = random.in_cube(3);
  Points source(3, 300);
  for (Index i = 0; i < 300; ++i) source.col(i) = centers.col(i % 3) + random.in_ball(0.01);
  Options options;
  options.noise_bound = 0.02;
  const Result result = register_correspondences(source, source, options);
  EXPECT_EQ(result.inliers.size(), 300u);
  EXPECT_NE(result.verdict, Verdict::Trusted) << result.verdict_reason;
}

TEST(Verdict, OfDistinctMatchesIsThatWithoutCopiesOfOthers) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto problem = random_problem(seed, 30, 33);
    const Index num_copies = 100;
    Points source(3, 30 + 3 * num_copies), target(3, source.cols());
    source << problem.source.leftCols(30), problem.source.rightCols(3).replicate(1, num_copies);
    target << problem.target.leftCols(30), problem.target.rightCols(3).replicate(1, num_copies);
    const Result result = register_correspondences(source, target, problem.options());
    EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  }
}

TEST(Verdict, DoesNotTrustNearestNeighboursOfCloudsThatLieApart) {
  testing::RandomGeometry random(2);
  int num_trusted = 0, num_named = 0;
  for (int k = 0; k < 10; ++k) {
    const Points source = random.in_cube(600);
    // turned by a radian or two about an axis through the cloud
    const Points cloud =
        geometry::turn_about(random.unit(), random.uniform(1, 2)) * random.in_cube(600);
    Points target(3, source.cols());
    for (Index i = 0; i < source.cols(); ++i) {
      Index nearest;
      (cloud.colwise() - source.col(i)).colwise().squaredNorm().minCoeff(&nearest);
      target.col(i) = cloud.col(nearest);
    }
    Options options;
    options.noise_bound = 0.05;
    const Result result = register_correspondences(source, target, options);
    num_trusted += result.verdict == Verdict::Trusted;
    num_named += says(result, "nearest neighbours under this pose");
  }
  EXPECT_EQ(num_trusted, 0);
  EXPECT_GT(num_named, 5);
}

TEST(Verdict, TrustsNoisyMatchesWhoseTargetsAreAboutTheNearest) {
  testing::RandomGeometry random(4);
  for (const double noise : {0.02, 0.05, 0.1}) {  // points lie about 0.06 apart
    const Points source = random.in_cube(1000);
    Points target = source;
    for (auto point : target.colwise()) point += noise / 2 * random.normal() * random.unit();
    for (const double bound : {noise / 3, noise / 2, noise}) {
      Options options;
      options.noise_bound = bound;
      const Result result = register_correspondences(source, target, options);
      EXPECT_EQ(result.verdict, Verdict::Trusted) << noise << " " << result.verdict_reason;
    }
  }
}

TEST(Verdict, OfAPoseWhoseRivalHasAsMuchEvidenceIsDoubtful) {
  testing::RandomGeometry random(3);
  const Points source = random.in_cube(80);
  const Similarity one = random.similarity(1, 1, 1), other = random.similarity(1, 1, 1);
  Points target(3, 80);
  target << one.apply(source.leftCols(40)), other.apply(source.rightCols(40));
  Options options;
  options.noise_bound = 0.01;
  options.num_hypotheses = 2;
  const Result result = register_correspondences(source, target, options);
  EXPECT_GT(result.runner_up_ratio(), 0.9);
  EXPECT_EQ(result.verdict, Verdict::Doubtful) << result.verdict_reason;
  EXPECT_TRUE(says(result, "ambiguous"));
}

TEST(Verdict, WithoutAPoseSaysWhy) {
  Options options;
  options.noise_bound = 0.1;
  const Result none = register_correspondences(Points(3, 0), Points(3, 0), options);
  EXPECT_EQ(none.verdict, Verdict::Untrusted);
  EXPECT_TRUE(says(none, "there is no pose: 0 correspondences"));
  Points line(3, 5);
  line << 0, 1, 2, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0;
  const Result degenerate = register_correspondences(line, line, options);
  EXPECT_EQ(degenerate.verdict, Verdict::Untrusted);
  EXPECT_TRUE(says(degenerate, "one of many"));
}

TEST(Verdict, NamesUnitsThatDiffer) {
  const auto problem = random_problem(5, 30, 0);
  Options options;
  options.noise_bound = 1e-5;
  const Points in_meters = 1e-3 * problem.target;
  const Result result = register_correspondences(problem.source, in_meters, options);
  EXPECT_EQ(result.verdict, Verdict::Untrusted);
  EXPECT_TRUE(says(result, "the source seems to be in millimeters and the target in meters"))
      << result.verdict_reason;
}

}  // namespace
}  // namespace gmcr::registration
