#include "search/sampled_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "built_problem.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/registration.hpp"
#include "search/best_poses.hpp"

namespace gmcr::search {
namespace {

/// 200,000 matches, of which a share is right, and memory for the graph of 10,000.
testing::Problem many_matches(Index num_right) {
  return testing::random_problem(1, num_right, 200'000 - num_right);
}

Options with_little_memory(Options options) {
  options.memory_limit = BitsetGraph::bytes_required(10'000);
  return options;
}

bool says_memory(const Result& result) {
  const auto& limits = result.diagnostics.limits_hit;
  return std::any_of(limits.begin(), limits.end(), [](const LimitHit& hit) {
    return hit.limit == Limit::Memory && hit.sentence.find("sample") != std::string::npos;
  });
}

TEST(SampledSearch, FindsThePoseOfMoreMatchesThanTheMemoryTakes) {
  const auto matches = many_matches(4000);
  for (const Options& options : {matches.options(), matches.options_with_unknown_scale()}) {
    const Result result =
        register_correspondences(matches.source, matches.target, with_little_memory(options));
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_LT(mean_point_error(result.target_from_source, matches.truth, matches.source), 1e-3);
    EXPECT_GT(result.inliers.size(), 3900u);
    EXPECT_TRUE(says_memory(result));
    EXPECT_EQ(result.certificate.upper, 200'000);
    EXPECT_FALSE(result.certificate.certified);
    EXPECT_EQ(result.evidence, static_cast<double>(result.inliers.size())) << "a count";
  }
}

TEST(SampledSearch, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto matches = many_matches(4000);
  Options options = with_little_memory(matches.options());
  options.num_threads = 1;
  const Result one = register_correspondences(matches.source, matches.target, options);
  options.num_threads = 3;
  const Result three = register_correspondences(matches.source, matches.target, options);
  EXPECT_EQ(one.target_from_source.matrix(), three.target_from_source.matrix());
  EXPECT_EQ(one.inliers, three.inliers);
}

TEST(SampledSearch, TakesTheBoundOfEachMatchWithIt) {
  const auto matches = many_matches(4000);
  Options options = with_little_memory(matches.options());
  options.noise_bound = 0;
  options.noise_bounds.assign(200'000, 0.01);
  for (std::size_t i = 0; i < 200'000; i += 2) options.noise_bounds[i] = 0.02;
  const Result result = register_correspondences(matches.source, matches.target, options);
  EXPECT_LT(mean_point_error(result.target_from_source, matches.truth, matches.source), 1e-3);
}

TEST(SampledSearch, KeepsToThePriorsAndTheirAdmittedMatches) {
  const auto matches = many_matches(4000);
  Options options = with_little_memory(matches.options());
  options.initial_pose = InitialPose{matches.truth, 0.1, 0.05};
  const Result result = register_correspondences(matches.source, matches.target, options);
  EXPECT_LT(mean_point_error(result.target_from_source, matches.truth, matches.source), 1e-3);
  EXPECT_LT(result.diagnostics.num_used, 200'000);
}

TEST(SampledSearch, OfSeveralMotionsReturnsAsManyAsAreAskedFor) {
  auto matches = many_matches(8000);
  testing::RandomGeometry random(2);
  const Similarity other = random.similarity(1, 1, 1);
  for (Index i = 0; i < 3000; ++i) matches.target.col(i) = other * matches.source.col(i);
  Options options = with_little_memory(matches.options());
  options.num_hypotheses = 2;
  const Result result = register_correspondences(matches.source, matches.target, options);
  EXPECT_LT(mean_point_error(result.target_from_source, matches.truth, matches.source), 1e-3);
  ASSERT_EQ(result.alternatives.size(), 1u);
  EXPECT_LT(mean_point_error(result.alternatives[0].target_from_source, other, matches.source),
            1e-3);
}

TEST(SampledSearch, OfAPartIsASearchOfTheWholeOfItWhateverTheTime) {
  const auto matches = testing::random_problem(7, 3000, 3000);
  Options options = matches.options();
  options.time_limit = 1e-6;
  problem::Run run(options);
  const problem::Problem any(matches.source, matches.target, options, run);
  EXPECT_TRUE(any.is_sampled());
  const problem::Problem whole(matches.source, matches.target, options, run, problem::Route::Whole);
  EXPECT_FALSE(whole.is_sampled());
  EXPECT_FALSE(BestPoseSearch(whole, run).found().poses.empty());
}

TEST(SampledSearch, AnswersWhereCopiesTakeAllOfTheTime) {
  const auto matches = testing::random_problem(8, 500'000, 500'000);
  Options options = matches.options();
  options.time_limit = 0.05;
  const Result result = register_correspondences(matches.source, matches.target, options);
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_LT(mean_point_error(result.target_from_source, matches.truth, matches.source), 0.01);
}

TEST(SampledSearch, IsNotForTheMethodOfThePaperNorForTooLittleMemory) {
  const auto matches = many_matches(4000);
  Options paper = with_little_memory(matches.options());
  paper.method = Method::Paper;
  EXPECT_THROW(register_correspondences(matches.source, matches.target, paper), InvalidOption);
  Options small = matches.options();
  small.memory_limit = 1000;
  EXPECT_THROW(register_correspondences(matches.source, matches.target, small), InvalidOption);
}

}  // namespace
}  // namespace gmcr::search
