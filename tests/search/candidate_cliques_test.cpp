#include "search/candidate_cliques.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "built_problem.hpp"
#include "problem/graph/consistency_graph.hpp"

namespace gmcr::search {
namespace {

using testing::BuiltProblem;
using testing::options_with;

Options options_between(double scale_min, double scale_max) {
  Options options = options_with(Evidence::Distinct);
  options.scale_mode = ScaleMode::Estimated;
  options.scale_range = ScaleRange{scale_min, scale_max};
  return options;
}

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

TEST(WeightsOf, AreTheMostThatACorrespondenceGivesInTheRange) {
  const BuiltProblem built(near_pairs(1), options_between(0.2, 3));
  const ScaleRange scales{0.2, 3};
  const std::vector<double> weights = weights_of(built.problem, Measure::Evidence, scales);
  bool depends_on_scale = false;
  for (Index i = 0; i < 30; ++i) {
    const double weight = weights[static_cast<std::size_t>(i)];
    EXPECT_EQ(weight, built.objective().weight(i, scales.max));
    for (double scale = scales.min; scale <= scales.max; scale += 0.1) {
      EXPECT_GE(weight, built.objective().weight(i, scale));
      depends_on_scale = depends_on_scale || weight > built.objective().weight(i, scale);
    }
  }
  EXPECT_TRUE(depends_on_scale);
  EXPECT_EQ(weights_of(built.problem, Measure::Inliers, scales), std::vector<double>(30, 1.0));
}

TEST(PoseSearch, KeepsTheBestPoseAndTheMostOfEachMeasure) {
  const auto matches = testing::random_problem(2, 20, 20);
  BuiltProblem built(matches, options_with(Evidence::Distinct));
  PoseSearch search(built.problem, built.run);
  EXPECT_FALSE(search.best());
  search.try_pose(built.centred(matches.truth));
  ASSERT_TRUE(search.best());
  EXPECT_EQ(search.to_beat(Measure::Inliers), 20);
  const problem::Hypothesis best = *search.best();
  Similarity worse = matches.truth;
  worse.translation += Eigen::Vector3d(1, 0, 0);
  search.try_pose(built.centred(worse));
  EXPECT_EQ(search.best()->inliers, best.inliers);
  EXPECT_EQ(search.to_beat(Measure::Inliers), 20);
}

TEST(PoseSearch, LeavesOutTheHypothesesThatAreKnown) {
  const auto matches = testing::random_problem(3, 20, 20);
  BuiltProblem built(matches, options_with(Evidence::Distinct));
  const problem::Hypothesis known = built.objective().judge(built.centred(matches.truth));
  PoseSearch search(built.problem, built.run, {known});
  const RangeGraph range = build_range_graph(search, built.problem.scales());
  for (const Index i : known.inliers) EXPECT_EQ(range.graph.degree(i), 0);
  const BitsetGraph whole =
      problem::consistency_graph(built.problem.arrays(), built.problem.scales(), 1);
  const std::vector<Index> near = built.objective().within(known.pose, 3);
  const auto is_explained = [&](Index i) { return std::count(near.begin(), near.end(), i) > 0; };
  for (Index i = 20; i < 40; ++i) {
    for (Index j = 20; j < i; ++j) {
      EXPECT_EQ(range.graph.has_edge(i, j),
                whole.has_edge(i, j) && !is_explained(i) && !is_explained(j));
    }
  }
  search.try_pose(built.centred(matches.truth));
  EXPECT_FALSE(search.best());
}

TEST(SearchClique, BoundsTheTruthByBothMeasuresWhateverItsBudget) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const testing::Problem matches = near_pairs(seed);
    for (const std::uint64_t max_nodes : {1, 1000}) {
      BuiltProblem built(matches, options_between(0.9, 1.1));
      PoseSearch search(built.problem, built.run);
      const RangeGraph range = build_range_graph(search, built.problem.scales());
      const problem::Hypothesis truth = built.objective().judge(built.centred(matches.truth));
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
