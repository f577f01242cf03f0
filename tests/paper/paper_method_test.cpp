#include <gtest/gtest.h>

#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"
#include "parallel/deadline.hpp"
#include "problems.hpp"

namespace gmcr::paper {
namespace {

using testing::random_problem;

TEST(PaperMethod, RecoversAKnownTransformWithKnownAndUnknownScale) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto problem = random_problem(seed, 40, 40, 2);
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      options.method = Method::Paper;
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(result.status, Status::Ok);
      EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.02);
      EXPECT_TRUE(result.diagnostics.limits_hit.empty());
    }
  }
}

TEST(PaperMethod, UsesAllCorrespondencesWhateverTheirNumber) {
  // only the last rows agree: a method that keeps the first rows finds nothing
  auto problem = random_problem(7, 40, 460);
  problem.source = problem.source.rowwise().reverse().eval();
  problem.target = problem.target.rowwise().reverse().eval();
  Options options = problem.options();
  options.method = Method::Paper;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_GE(result.inliers.size(), 35u);
  EXPECT_GE(result.inliers.front(), 400);
}

TEST(PaperMethod, CommitsToOneScaleWhereTheDefaultLooksAtMany) {
  // structured outliers: the deepest scale interval is often a wrong one
  int paper = 0, gmcr = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SyntheticOptions synthetic = paper_structured_options();
    synthetic.outlier_rate = 0.9;
    synthetic.seed = seed;
    const SyntheticProblem problem = make_synthetic(synthetic);
    Options options;
    options.noise_bound = problem.noise_bound;
    options.scale_mode = ScaleMode::Estimated;
    const auto succeeds = [&](Method method) {
      options.method = method;
      const Result result = register_correspondences(problem.source, problem.target, options);
      return result.status == Status::Ok &&
             mean_point_error(result.target_from_source, problem.target_from_source,
                              problem.source) < 0.3;
    };
    gmcr += succeeds(Method::Gmcr);
    paper += succeeds(Method::Paper);
  }
  EXPECT_GE(gmcr, 8);
  EXPECT_LT(paper, gmcr);
}

TEST(PaperMethod, CallsCollinearInliersDegenerate) {
  testing::RandomGeometry random(3);
  Points source(3, 20);
  for (Index i = 0; i < 20; ++i) source.col(i) = random.uniform(-1, 1) * Eigen::Vector3d(1, 2, 3);
  const Points target = random.similarity(1, 1, 1).apply(source);
  Options options;
  options.noise_bound = 0.01;
  options.method = Method::Paper;
  const Result result = register_correspondences(source, target, options);
  EXPECT_EQ(result.status, Status::Degenerate);
  EXPECT_EQ(result.inliers.size(), 20u);
}

TEST(PaperMethod, KeepsToTheTimeLimitInsideItsGraphs) {
  const auto problem = random_problem(12, 450, 50);
  Options options = problem.options();
  options.method = Method::Paper;
  options.time_limit = 0.2;
  const parallel::Deadline clock(0);
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_LT(clock.elapsed(), 20);  // all of its rotation graph takes minutes
  EXPECT_FALSE(result.diagnostics.limits_hit.empty());
}

TEST(PaperMethod, SaysWhenTheMemoryBudgetKeepsPairsOut) {
  const auto problem = random_problem(8, 80, 0);
  Options options = problem.options();
  options.method = Method::Paper;
  options.memory_limit = 400'000;  // holds the 3,160 TIMs, but not a graph of them
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.status, Status::Ok);
  ASSERT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_NE(result.diagnostics.limits_hit[0].sentence.find("of 3160 pairs"), std::string::npos)
      << result.diagnostics.limits_hit[0].sentence;
}

TEST(PaperMethod, RefusesAScaleStageThatDoesNotFitTheMemoryBudget) {
  const auto problem = random_problem(9, 100, 0);
  Options options = problem.options_with_unknown_scale();
  options.method = Method::Paper;
  options.memory_limit = 100'000;
  EXPECT_THROW(register_correspondences(problem.source, problem.target, options),
               std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::paper
