#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

/// 10 true matches against 15 that follow a wrong pose, 12 of them copies of one.
struct Contest {
  testing::Problem problem;
  Similarity wrong;

  bool is_truth(const Similarity& pose) const {
    return mean_point_error(pose, problem.truth, problem.source) < 0.03;
  }
  bool is_wrong(const Similarity& pose) const {
    return mean_point_error(pose, wrong, problem.source) < 0.03;
  }
};

Contest contest(std::uint64_t seed, double wrong_scale) {
  Contest c{testing::random_problem(seed, 10, 15), {}};
  testing::RandomGeometry random(seed + 100);
  c.wrong = random.similarity(wrong_scale, wrong_scale, 1);
  for (Index i = 10; i < 25; ++i) {
    if (i > 13) c.problem.source.col(i) = c.problem.source.col(13) + random.in_ball(1e-3);
    c.problem.target.col(i) = c.wrong * c.problem.source.col(i);
  }
  return c;
}

std::vector<std::pair<Contest, Options>> contests() {
  std::vector<std::pair<Contest, Options>> all;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Contest known = contest(seed, 1), unknown = contest(seed, 1.6);
    all.emplace_back(known, known.problem.options());
    all.emplace_back(unknown, unknown.problem.options_with_unknown_scale());
  }
  return all;
}

TEST(Evidence, DecidesBetweenPosesAtKnownAndUnknownScale) {
  for (auto& [c, options] : contests()) {
    const Points &source = c.problem.source, &target = c.problem.target;
    const Result distinct = register_correspondences(source, target, options);
    EXPECT_TRUE(c.is_truth(distinct.target_from_source));
    EXPECT_EQ(distinct.certificate.lower, 10);
    EXPECT_NEAR(distinct.certificate.evidence.lower, 10, 1);
    EXPECT_GE(distinct.certificate.upper, 15);  // the count of the wrong pose is larger
    EXPECT_LT(distinct.certificate.evidence.upper, 15);
    options.evidence = Evidence::Count;
    const Result count = register_correspondences(source, target, options);
    EXPECT_TRUE(c.is_wrong(count.target_from_source));
    EXPECT_EQ(count.evidence, 15);
  }
}

/// Right matches of two bounds, and a few that follow another motion within the tight one.
TEST(Evidence, OfTightBoundsIsNotTakenByLooseOnes) {
  constexpr Index kRight = 30, kWrong = 20, kLoose = 20, kAll = kRight + kWrong + kLoose;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    testing::RandomGeometry random(seed);
    const Similarity truth = random.similarity(1, 1, 3), other = random.similarity(1, 1, 3);
    const Points source = 4 * random.in_cube(kAll);
    Points target(3, kAll);
    Options options;
    for (Index i = 0; i < kAll; ++i) {
      const double bound = i < kRight + kWrong ? 0.01 : 1;
      const bool is_wrong = i >= kRight && i < kRight + kWrong;
      target.col(i) = (is_wrong ? other : truth) * source.col(i) + random.in_ball(bound);
      options.noise_bounds.push_back(bound);
    }
    const Result result = register_correspondences(source, target, options);
    EXPECT_LT(mean_point_error(result.target_from_source, truth, source), 0.01);
  }
}

TEST(Evidence, OrdersTheHypotheses) {
  for (auto& [c, options] : contests()) {
    const Points &source = c.problem.source, &target = c.problem.target;
    options.num_hypotheses = 2;
    const Result distinct = register_correspondences(source, target, options);
    ASSERT_EQ(distinct.alternatives.size(), 1u);
    EXPECT_TRUE(c.is_truth(distinct.target_from_source));
    EXPECT_TRUE(c.is_wrong(distinct.alternatives[0].target_from_source));
    EXPECT_EQ(distinct.alternatives[0].inliers.size(), 15u);
    EXPECT_LT(distinct.runner_up_ratio(), 0.5);  // three matches and a cluster
    options.evidence = Evidence::Count;
    const Result count = register_correspondences(source, target, options);
    ASSERT_EQ(count.alternatives.size(), 1u);
    EXPECT_TRUE(c.is_wrong(count.target_from_source));
    EXPECT_TRUE(c.is_truth(count.alternatives[0].target_from_source));
    EXPECT_NEAR(count.runner_up_ratio(), 10.0 / 15, 1.5 / 15);  // less one that the fit leaves out
  }
}

TEST(Evidence, DecidesWhatIsAnotherInstance) {
  for (auto& [c, options] : contests()) {
    const Points &source = c.problem.source, &target = c.problem.target;
    // the cluster has more inliers than the first instance, but less than half of its evidence
    const InstanceOptions instances{.min_instance_share = 0.6};
    const auto distinct = register_instances(source, target, options, instances);
    ASSERT_EQ(distinct.size(), 1u);
    EXPECT_TRUE(c.is_truth(distinct[0].target_from_source));
    options.evidence = Evidence::Count;
    EXPECT_EQ(register_instances(source, target, options, instances).size(), 2u);
  }
}

TEST(Evidence, IsWhatTheJointSearchProvesToo) {
  for (auto& [c, options] : contests()) {
    options.certify = true;
    const Result result = register_correspondences(c.problem.source, c.problem.target, options);
    EXPECT_TRUE(c.is_truth(result.target_from_source));
    EXPECT_TRUE(result.certificate.evidence.certified);
    EXPECT_EQ(result.certificate.upper, 15);
    EXPECT_FALSE(result.certificate.certified);
  }
}

TEST(Evidence, OfTightMatchesIsNotAbsorbedByALooseOne) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    // 20 tight right matches against 12 of another pose, and loose ones near the right ones
    auto problem = testing::random_problem(seed, 20, 30);
    testing::RandomGeometry random(seed + 500);
    const Similarity rival = random.similarity(1, 1, 1);
    for (Index i = 20; i < 32; ++i) problem.target.col(i) = rival * problem.source.col(i);
    Options options = problem.options();
    options.noise_bound = 0;
    options.noise_bounds.assign(50, problem.noise_bound);
    for (Index i = 32; i < 38; ++i) {
      problem.target.col(i) = problem.truth * problem.source.col(i) + random.in_ball(0.5);
      options.noise_bounds[static_cast<std::size_t>(i)] = 0.5;
    }
    const Result result = register_correspondences(problem.source, problem.target, options);
    EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.02);
  }
}

}  // namespace
}  // namespace gmcr::registration
