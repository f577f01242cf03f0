#include <gtest/gtest.h>

#include "problem/consistency_graph.hpp"
#include "problems.hpp"
#include "search/incumbent.hpp"

namespace gmcr::search {
namespace {

constexpr std::size_t kEnough = 1 << 20;

/// A search for poses, with all that it refers to.
struct Bench {
  problem::Correspondences correspondences;
  Options options;
  Diagnostics diagnostics;
  problem::SolveContext context{options, diagnostics};
  problem::Objective objective{correspondences, Evidence::Distinct, kEnough};
  estimation::PoseConstraints constraints;
  problem::PairFilter filter{correspondences, options, false, constraints.scales};

  Bench(const testing::Problem& problem, const ScaleRange& scales)
      : correspondences{problem.source, problem.target,
                        Eigen::ArrayXd::Constant(problem.source.cols(), problem.noise_bound)},
        options(problem.options()),
        constraints{scales} {}

  PoseSearch search(std::vector<problem::Hypothesis> found = {}) {
    return {context, objective, constraints, filter, std::move(found)};
  }
};

/// Pairs that are the same evidence at small scales and not at large ones.
testing::Problem near_pairs(std::uint64_t seed) {
  testing::Problem problem = testing::random_problem(seed, 20, 10);
  testing::RandomGeometry random(seed + 1);
  for (Index i = 0; i < 10; ++i) {
    problem.source.col(i) = problem.source.col(i + 10) + 0.05 * random.unit();
    problem.target.col(i) = problem.target.col(i + 10) + random.in_ball(0.02);
  }
  return problem;
}

TEST(PoseSearch, WeighsACorrespondenceByTheMostItGivesInTheRange) {
  const ScaleRange scales{0.2, 3};
  Bench bench(near_pairs(1), scales);
  const PoseSearch search = bench.search();
  const std::vector<double> weights = search.weights(Measure::Evidence, scales);
  bool depends_on_scale = false;
  for (Index i = 0; i < 30; ++i) {
    const double weight = weights[static_cast<std::size_t>(i)];
    EXPECT_EQ(weight, bench.objective.weight(i, scales.max));
    for (double scale = scales.min; scale <= scales.max; scale += 0.1) {
      EXPECT_GE(weight, bench.objective.weight(i, scale));
      depends_on_scale = depends_on_scale || weight > bench.objective.weight(i, scale);
    }
  }
  EXPECT_TRUE(depends_on_scale);
  EXPECT_EQ(search.weights(Measure::Inliers, scales), std::vector<double>(30, 1.0));
}

TEST(PoseSearch, KeepsTheBestPoseAndTheMostOfEachMeasure) {
  const auto problem = testing::random_problem(2, 20, 20);
  Bench bench(problem, {1, 1});
  PoseSearch search = bench.search();
  EXPECT_FALSE(search.best());
  search.offer(problem.truth);
  ASSERT_TRUE(search.best());
  EXPECT_EQ(search.to_beat(Measure::Inliers), 20);
  const problem::Hypothesis best = *search.best();
  Similarity worse = problem.truth;
  worse.translation += Eigen::Vector3d(1, 0, 0);
  search.offer(worse);
  EXPECT_EQ(search.best()->inliers, best.inliers);
  EXPECT_EQ(search.to_beat(Measure::Inliers), 20);
}

TEST(PoseSearch, LeavesOutTheHypothesesThatAreKnown) {
  const auto problem = testing::random_problem(3, 20, 20);
  Bench bench(problem, {1, 1});
  const problem::Hypothesis known = bench.objective.judge(problem.truth);
  PoseSearch search = bench.search({known});
  const RangeGraph range = build_range_graph(search, search.scales());
  for (const Index i : known.inliers) EXPECT_EQ(range.graph.degree(i), 0);
  const BitsetGraph whole = problem::consistency_graph(search.arrays(), search.scales(), 1);
  for (Index i = 20; i < 40; ++i) {
    for (Index j = 20; j < i; ++j) EXPECT_EQ(range.graph.has_edge(i, j), whole.has_edge(i, j));
  }
  search.offer(problem.truth);
  EXPECT_FALSE(search.best());
  EXPECT_EQ(search.to_beat(Measure::Inliers), 0);
}

TEST(PoseSearch, TightensTheBoundsOfTheFirstHypothesisOnly) {
  const auto problem = testing::random_problem(4, 10, 0);
  Bench bench(problem, {1, 1});
  EXPECT_FALSE(bench.search().certifies());
  bench.options.certify = true;
  EXPECT_TRUE(bench.search().certifies());
  EXPECT_FALSE(bench.search({bench.objective.judge(problem.truth)}).certifies());
}

TEST(SearchClique, BoundsTheTruthByBothMeasuresWhateverItsBudget) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const testing::Problem problem = near_pairs(seed);
    for (const std::uint64_t max_nodes : {1, 1000}) {
      Bench bench(problem, {0.9, 1.1});
      PoseSearch search = bench.search();
      const RangeGraph range = build_range_graph(search, search.scales());
      const problem::Hypothesis truth = bench.objective.judge(problem.truth);
      for (const Measure measure : {Measure::Evidence, Measure::Inliers}) {
        const double bound = search_clique(search, range, measure, max_nodes);
        const double of_truth =
            measure == Measure::Inliers ? static_cast<double>(truth.num_inliers()) : truth.evidence;
        EXPECT_GE(bound, of_truth - 1e-9);
        EXPECT_GE(bound, search.to_beat(measure) - 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace gmcr::search
