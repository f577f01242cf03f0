#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::random_problem;

std::vector<Index> within_bound(const Result& result, const Points& source, const Points& target,
                                double bound) {
  std::vector<Index> inliers;
  for (Index i = 0; i < source.cols(); ++i) {
    const Eigen::Vector3d image = result.target_from_source * source.col(i);
    if ((target.col(i) - image).norm() <= bound) inliers.push_back(i);
  }
  return inliers;
}

TEST(RegisterCorrespondences, RecoversAKnownTransform) {
  for (const double scale : {0.2, 1.0, 7.0}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto problem = random_problem(seed, 30, 270, scale);
      for (const auto& options : {problem.options(), problem.options_with_unknown_scale()}) {
        const Result result = register_correspondences(problem.source, problem.target, options);
        EXPECT_EQ(result.status, Status::Ok);
        EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.01);
        EXPECT_GE(result.certificate.lower, 29);
      }
    }
  }
}

TEST(RegisterCorrespondences, InliersAreExactlyTheCorrespondencesWithinTheBound) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto problem = random_problem(seed, 20, 80);
    for (const Method method : {Method::Gmcr, Method::Paper}) {
      Options options = problem.options();
      options.method = method;
      options.noise_bound = 0.0125;
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(result.inliers, within_bound(result, problem.source, problem.target, 0.0125));
      EXPECT_EQ(result.certificate.lower, static_cast<Index>(result.inliers.size()));
    }
  }
}

TEST(EvaluateConsensus, OfTheReturnedPoseIsTheReturnedConsensus) {
  const auto problem = random_problem(3, 20, 80);
  for (const Evidence evidence : {Evidence::Distinct, Evidence::Count}) {
    Options options = problem.options();
    options.noise_bound = 0.05;
    options.evidence = evidence;
    const Result result = register_correspondences(problem.source, problem.target, options);
    const Consensus consensus =
        evaluate_consensus(result.target_from_source, problem.source, problem.target, options);
    EXPECT_EQ(consensus.inliers, result.inliers);
    EXPECT_NEAR(consensus.evidence, result.evidence, 1e-9);
    Similarity elsewhere;
    elsewhere.translation = Eigen::Vector3d(100, 0, 0);
    EXPECT_TRUE(
        evaluate_consensus(elsewhere, problem.source, problem.target, options).inliers.empty());
  }
}

TEST(RegisterCorrespondences, BoundsPerCorrespondenceTakeTheirOwnPart) {
  auto problem = random_problem(4, 20, 20);
  problem.target.col(0) += Eigen::Vector3d(0.15, 0, 0);
  Options options;
  options.noise_bounds.assign(40, 0.01);
  const Result tight = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(std::count(tight.inliers.begin(), tight.inliers.end(), 0), 0);
  options.noise_bounds[0] = 0.2;
  const Result loose = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(std::count(loose.inliers.begin(), loose.inliers.end(), 0), 1);
}

TEST(RegisterCorrespondences, ScaleRangeKeepsTheScaleInside) {
  const auto problem = random_problem(5, 40, 10, 3);
  Options options = problem.options_with_unknown_scale();
  options.scale_range = ScaleRange{2.9, 3.1};
  const Result inside = register_correspondences(problem.source, problem.target, options);
  EXPECT_NEAR(inside.target_from_source.scale, 3, 0.05);
  EXPECT_GE(inside.inliers.size(), 39u);
  options.scale_range = ScaleRange{0.5, 0.6};
  const Result outside = register_correspondences(problem.source, problem.target, options);
  EXPECT_LT(outside.inliers.size(), 15u);
  if (outside.status == Status::Ok) {
    EXPECT_GE(outside.target_from_source.scale, 0.5);
    EXPECT_LE(outside.target_from_source.scale, 0.6);
  }
}

TEST(RegisterCorrespondences, OneToOneIsNotFooledByMatchesThatShareAPoint) {
  // 15 true matches against 8 wrong ones, each three times
  auto problem = random_problem(6, 15, 24);
  const Similarity wrong = testing::RandomGeometry(60).similarity(1, 1, 1);
  for (Index i = 15; i < 39; ++i) {
    if (i >= 23) problem.source.col(i) = problem.source.col(i - 8);
    problem.target.col(i) = wrong * problem.source.col(i);
    if (i >= 31) problem.target(0, i) += 0.001;
  }
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    Options options = problem.options();
    options.method = method;
    options.evidence = Evidence::Count;
    const Result many = register_correspondences(problem.source, problem.target, options);
    EXPECT_LT(mean_point_error(many.target_from_source, wrong, problem.source), 0.02);
    options.one_to_one = true;
    const Result one = register_correspondences(problem.source, problem.target, options);
    EXPECT_LT(mean_point_error(one.target_from_source, problem.truth, problem.source), 0.02);
    EXPECT_EQ(one.diagnostics.num_used, 39);
    EXPECT_GE(one.certificate.upper, 24);  // the bound is on all inliers, of the wrong pose too
  }
}

TEST(RegisterCorrespondences, OneToOneFindsThePoseThatOnlyLaterMatchesShow) {
  // the first match of each source is wrong
  auto problem = random_problem(15, 20, 20);
  problem.source.leftCols(20) = problem.source.rightCols(20).eval();
  problem.target.rightCols(20) = problem.truth.apply(problem.source.rightCols(20));
  problem.target.leftCols(20) = testing::RandomGeometry(61).in_cube(20, 2);
  Options options = problem.options();
  options.one_to_one = true;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_EQ(result.inliers.size(), 20u);
  EXPECT_EQ(result.inliers.front(), 20);
}

TEST(RegisterCorrespondences, OneToOneStillReportsAllWithinTheBound) {
  auto problem = random_problem(16, 20, 20);
  for (Index i = 20; i < 30; ++i) {
    problem.source.col(i) = problem.source.col(i - 20);
    problem.target.col(i) = problem.target.col(i - 20);
  }
  Options options = problem.options();
  options.one_to_one = true;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.diagnostics.num_used, 40);
  EXPECT_EQ(result.inliers, within_bound(result, problem.source, problem.target, 0.01));
  EXPECT_EQ(result.certificate.lower, 30);
  EXPECT_EQ(result.certificate.upper, 30);  // the truth holds 20 and 10 copies
  EXPECT_TRUE(result.certificate.certified);
}

TEST(RegisterCorrespondences, FindsTheScaleDespiteAPointFarOut) {
  for (const double distance : {1e3, 1e6}) {
    auto problem = random_problem(17, 50, 50);
    problem.target.col(99) = Eigen::Vector3d(distance, 0, 0);
    const Result result = register_correspondences(problem.source, problem.target,
                                                   problem.options_with_unknown_scale());
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_GE(result.certificate.lower, 49);
    EXPECT_LT(result.diagnostics.scale_range.min, 1);
    EXPECT_GT(result.diagnostics.scale_range.max, 1);
  }
}

TEST(RegisterCorrespondences, OfTheShortestTimeStillOffersAPose) {
  const auto problem = random_problem(18, 60, 20);
  Options options = problem.options();
  options.time_limit = 1e-9;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_FALSE(result.certificate.certified);
}

TEST(RegisterCorrespondences, ATimeThatEndsWhileTheGraphIsBuiltLeavesTheTrivialBound) {
  const auto problem = random_problem(19, 3000, 3000);
  Options options = problem.options();
  options.time_limit = 1e-4;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_FALSE(result.certificate.certified);
  EXPECT_EQ(result.certificate.upper, 6000);
}

TEST(RegisterCorrespondences, DistinctEvidenceIsNotFooledByACluster) {
  // 3 wrong matches and a cluster of 12 around a fourth share a wrong pose, against 10 true ones
  auto problem = random_problem(7, 10, 15);
  testing::RandomGeometry random(8);
  Similarity wrong = random.similarity(1, 1, 1);
  for (Index i = 10; i < 25; ++i) {
    if (i > 13) problem.source.col(i) = problem.source.col(13) + random.in_ball(1e-3);
    problem.target.col(i) = wrong * problem.source.col(i);
  }
  Options options = problem.options();
  const Result distinct = register_correspondences(problem.source, problem.target, options);
  EXPECT_LT(mean_point_error(distinct.target_from_source, problem.truth, problem.source), 0.02);
  EXPECT_GE(distinct.evidence, 9);
  options.evidence = Evidence::Count;
  const Result count = register_correspondences(problem.source, problem.target, options);
  EXPECT_LT(mean_point_error(count.target_from_source, wrong, problem.source), 0.02);
  EXPECT_EQ(count.evidence, 15);
}

TEST(RegisterCorrespondences, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto problem = random_problem(9, 30, 400);
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      if (method == Method::Paper && options.scale_mode == ScaleMode::Estimated) continue;
      options.method = method;
      options.num_threads = 1;
      const Result one = register_correspondences(problem.source, problem.target, options);
      options.num_threads = 5;
      const Result five = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(one.target_from_source.matrix(), five.target_from_source.matrix());
      EXPECT_EQ(one.inliers, five.inliers);
      EXPECT_EQ(one.certificate.upper, five.certificate.upper);
      EXPECT_EQ(five.diagnostics.num_threads, 5);
    }
  }
}

TEST(RegisterCorrespondences, AsksTheCliqueSolverThatItIsGiven) {
  /// Ours, and a count of the calls.
  struct CountingSolver : CliqueSolver {
    CliqueResult solve(const BitsetGraph& graph, const CliqueOptions& options) const override {
      ++calls;
      return max_clique(graph, options);
    }
    mutable int calls = 0;
  };
  const auto problem = random_problem(10, 20, 60);
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    Options options = problem.options();
    options.method = method;
    const Result own = register_correspondences(problem.source, problem.target, options);
    const auto solver = std::make_shared<CountingSolver>();
    options.clique_solver = solver;
    const Result plugged = register_correspondences(problem.source, problem.target, options);
    EXPECT_GT(solver->calls, 0);
    EXPECT_EQ(own.inliers, plugged.inliers);
  }
}

TEST(RegisterCorrespondences, StopsWhenTheTimeIsUpAndSaysSo) {
  const auto problem = random_problem(11, 20, 480);
  Options options = problem.options_with_unknown_scale();
  options.time_limit = 1e-9;
  const Result result = register_correspondences(problem.source, problem.target, options);
  ASSERT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_NE(result.diagnostics.limits_hit[0].sentence.find("time"), std::string::npos);
  EXPECT_FALSE(result.certificate.certified);
  EXPECT_GE(result.certificate.upper, 20);
}

TEST(RegisterCorrespondences, StopsWhenTheProgressCallbackSaysSo) {
  const auto problem = random_problem(12, 20, 480);
  Options options = problem.options_with_unknown_scale();
  int calls = 0;
  options.progress = [&](const Progress& progress) {
    EXPECT_GE(progress.fraction, 0);
    EXPECT_LE(progress.fraction, 1);
    return ++calls < 3;
  };
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(calls, 3);
  ASSERT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_NE(result.diagnostics.limits_hit[0].sentence.find("caller"), std::string::npos);
}

TEST(RegisterCorrespondences, StopsAtARequest) {
  const auto problem = random_problem(12, 20, 480);
  for (const NoiseMode noise : {NoiseMode::Given, NoiseMode::Estimated}) {
    Options options = problem.options_with_unknown_scale();
    options.noise_mode = noise;
    if (noise == NoiseMode::Estimated) options.noise_bound = 0;
    std::stop_source source;
    source.request_stop();
    options.stop = source.get_token();
    const Result result = register_correspondences(problem.source, problem.target, options);
    ASSERT_FALSE(result.diagnostics.limits_hit.empty());
    EXPECT_NE(result.diagnostics.limits_hit[0].sentence.find("caller"), std::string::npos)
        << result.diagnostics.limits_hit[0].sentence;
  }
}

TEST(RegisterCorrespondences, ReportsWhatItDid) {
  const auto problem = random_problem(13, 20, 80);
  const Result result = register_correspondences(problem.source, problem.target, problem.options());
  const Diagnostics& d = result.diagnostics;
  EXPECT_EQ(d.num_correspondences, 100);
  EXPECT_GE(d.num_candidates, 1);
  EXPECT_EQ(d.num_scale_ranges, 1);
  EXPECT_GT(d.total_seconds, 0);
  double sum = 0;
  for (const StageTime& stage : d.stages) sum += stage.seconds;
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, d.total_seconds);
}

}  // namespace
}  // namespace gmcr::registration
