#include "search/conflict_bounds.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"
#include "gmcr/clique.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "search/candidate_cliques.hpp"

namespace gmcr::search {
namespace {

using testing::BuiltProblem;

/// Right matches, copies of some of them, and wrong ones, some of these near the right place.
testing::Problem matches_with_copies(std::uint64_t seed, Index num_right, Index num_wrong) {
  auto matches = testing::random_problem(seed, num_right, num_wrong);
  testing::RandomGeometry random(seed + 100);
  for (Index i = 0; i < num_right / 4; ++i) {
    matches.source.col(i) = matches.source.col(i + num_right / 2) + random.in_ball(0.002);
    matches.target.col(i) = matches.target.col(i + num_right / 2) + random.in_ball(0.002);
  }
  for (Index i = num_right; i < num_right + num_wrong / 3; ++i) {
    matches.target.col(i) = matches.truth * matches.source.col(i) + random.in_ball(0.03);
  }
  return matches;
}

TEST(BoundsByConflicts, HoldForEveryCliqueWhateverThePose) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto matches = matches_with_copies(seed, 20 + static_cast<Index>(seed), 30);
    const BuiltProblem built(matches, matches.options());
    const BitsetGraph graph =
        problem::consistency_graph(built.problem.arrays(), built.problem.scales(), 1);
    const auto weights = weights_of(built.problem, Measure::Evidence, built.problem.scales());
    const auto largest = static_cast<double>(max_clique(graph).vertices.size());
    const double heaviest = max_weight_clique(graph, weights).weight;
    // of a good pose, of a poor one, and of one that holds next to nothing
    for (const double shift : {0.0, 0.008, 1.0}) {
      Similarity pose = matches.truth;
      pose.translation[0] += shift;
      const auto judged = built.objective().judge(built.centred(pose));
      const problem::PerMeasure bounds = bounds_by_conflicts(built.problem, judged);
      EXPECT_GE(bounds.inliers, largest) << seed;
      EXPECT_GE(bounds.evidence * (1 + 1e-9), heaviest) << seed;
      EXPECT_GE(bounds.inliers, static_cast<double>(judged.num_inliers()));
    }
  }
}

TEST(BoundsByConflicts, AreTightWhereMostAreRight) {
  for (const Index num_wrong : {0, 10, 100}) {
    const auto matches = testing::random_problem(3, 300, num_wrong);
    const BuiltProblem built(matches, matches.options());
    const auto judged = built.objective().judge(built.centred(matches.truth));
    const problem::PerMeasure bounds = bounds_by_conflicts(built.problem, judged);
    EXPECT_LE(bounds.inliers, 302) << num_wrong;
    EXPECT_LE(bounds.evidence, judged.evidence + 2) << num_wrong;
  }
}

TEST(BoundsByConflicts, AreAllWhereTheScaleIsUnknownOrTooManyAreLeft) {
  const auto matches = testing::random_problem(4, 50, 50);
  const BuiltProblem unknown(matches, matches.options_with_unknown_scale());
  const auto judged = unknown.objective().judge(unknown.centred(matches.truth));
  EXPECT_EQ(bounds_by_conflicts(unknown.problem, judged).inliers, 100);
  const auto many = testing::random_problem(5, 2000, 2000);
  const BuiltProblem built(many, many.options());
  const auto best = built.objective().judge(built.centred(many.truth));
  EXPECT_EQ(bounds_by_conflicts(built.problem, best).inliers, 4000);
}

}  // namespace
}  // namespace gmcr::search
