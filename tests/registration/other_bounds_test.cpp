#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::random_problem;

bool has_stage(const Result& result, const std::string& name) {
  return std::any_of(result.diagnostics.stages.begin(), result.diagnostics.stages.end(),
                     [&](const StageTime& stage) { return stage.name == name; });
}

double error_of(const Result& result, const testing::Problem& problem) {
  return mean_point_error(result.target_from_source, problem.truth, problem.source);
}

/// Noise of 0.03 in a ball, among many wrong matches.
testing::Problem noisy_problem(std::uint64_t seed) {
  auto problem = random_problem(seed, 12, 400);
  testing::RandomGeometry random(seed + 50);
  for (Index i = 0; i < 12; ++i) {
    problem.target.col(i) = problem.truth * problem.source.col(i) + random.in_ball(0.03);
  }
  return problem;
}

TEST(OtherBounds, FindThePoseThatABoundFarOffHides) {
  int num_found = 0, num_elsewhere = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto problem = noisy_problem(seed);
    for (const double bound : {0.006, 0.2}) {
      Options options = problem.options();
      options.noise_bound = bound;
      const Result result = register_correspondences(problem.source, problem.target, options);
      num_found += error_of(result, problem) < 0.03;
      const bool is_elsewhere = result.verdict_reason.find("; that is at ") != std::string::npos;
      num_elsewhere += is_elsewhere;
      EXPECT_TRUE(!is_elsewhere || has_stage(result, "other_bounds"));
      // inliers and certificate speak of the given bound
      const Eigen::ArrayXd residuals =
          (problem.target - result.target_from_source.apply(problem.source)).colwise().norm();
      EXPECT_EQ(static_cast<Index>(result.inliers.size()), (residuals <= bound).count());
      EXPECT_GE(result.certificate.upper, result.certificate.lower);
      const Eigen::ArrayXd held =
          (problem.target - result.certificate.target_from_source.apply(problem.source))
              .colwise()
              .norm();
      EXPECT_EQ(result.certificate.lower, (held <= bound).count());
      EXPECT_TRUE(result.inliers.size() >= 3 || result.verdict != Verdict::Trusted);
    }
  }
  EXPECT_GE(num_found, 37);
  EXPECT_GE(num_elsewhere, 25);
}

TEST(OtherBounds, AreLeftAloneWhereTheGivenOneIsSure) {
  const auto problem = random_problem(1, 20, 100);
  EXPECT_FALSE(has_stage(
      register_correspondences(problem.source, problem.target, problem.options()), "other_bounds"));
}

TEST(OtherBounds, AreTriedOnlyForTheAnswerOfOneKnownScale) {
  const auto problem = random_problem(2, 0, 60);
  Options options = problem.options();
  options.noise_bound = 0.05;
  const auto tries = [&](const Options& some) {
    return has_stage(register_correspondences(problem.source, problem.target, some),
                     "other_bounds");
  };
  EXPECT_TRUE(tries(options));
  Options other = options;
  other.num_hypotheses = 2;
  EXPECT_FALSE(tries(other));
  other = options;
  other.certify = true;
  EXPECT_FALSE(tries(other));
  other = options;
  other.scale_mode = ScaleMode::Estimated;
  EXPECT_FALSE(tries(other));
  other = options;
  other.method = Method::Paper;
  EXPECT_FALSE(tries(other));
  other = options;
  other.time_limit = 1e-9;
  EXPECT_FALSE(tries(other));
}

}  // namespace
}  // namespace gmcr::registration
