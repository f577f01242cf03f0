#include <cmath>

#include "clique/arbitrary.hpp"
#include "clique/graph/packed_graph.hpp"
#include "clique/nearly_complete/complement_kernel.hpp"
#include "clique/nearly_complete/complement_search.hpp"
#include "clique/oracles.hpp"
#include "clique/search/local_search.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

constexpr double kForever = 1e9;
constexpr std::uint64_t kAnyNodes = std::uint64_t{1} << 40;

/// Consistency graph of points in the unit cube with Gaussian noise: the members of a pair may
/// differ in length by `tolerance` standard deviations. The first vertices are outliers.
BitsetGraph noisy_inliers(Index num_vertices, Index num_outliers, double tolerance) {
  constexpr double kNoise = 0.01;
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, kNoise);
  Eigen::Matrix3Xd source(3, num_vertices), target(3, num_vertices);
  for (Index i = 0; i < num_vertices; ++i) {
    for (int d = 0; d < 3; ++d) {
      source(d, i) = uniform(generator);
      target(d, i) = i < num_outliers ? uniform(generator) : source(d, i) + normal(generator);
    }
  }
  BitsetGraph graph(num_vertices);
  for (Index i = 0; i < num_vertices; ++i) {
    for (Index j = 0; j < i; ++j) {
      const double difference =
          (source.col(i) - source.col(j)).norm() - (target.col(i) - target.col(j)).norm();
      if (std::abs(difference) <= tolerance * kNoise * std::sqrt(2.0)) graph.add_edge(i, j);
    }
  }
  return graph;
}

RC_GTEST_PROP(ComplementKernel, KeepsTheCliqueNumber, ()) {
  const BitsetGraph graph = test::arbitrary_graph(0, 16, 100);
  SearchBudget budget(kForever, 0);
  const ComplementKernel kernel = reduce_by_complement(graph, budget);
  Index clique_number = static_cast<Index>(kernel.taken.size());
  for (const std::vector<Index>& part : kernel.parts) {
    BitsetGraph induced(static_cast<Index>(part.size()));
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (graph.has_edge(part[i], part[j])) {
          induced.add_edge(static_cast<Index>(i), static_cast<Index>(j));
        }
      }
    }
    clique_number += test::brute_force_clique_number(induced);
  }
  RC_ASSERT(clique_number == test::brute_force_clique_number(graph));
}

TEST(ComplementKernel, OfTheComplementOfATreeHasNoPartLeft) {
  BitsetGraph tree(300);
  for (Index v = 1; v < 300; ++v) tree.add_edge(v, (v - 1) / 3);
  SearchBudget budget(kForever, 0);
  const BitsetGraph graph = test::complement_of(tree);
  const ComplementKernel kernel = reduce_by_complement(graph, budget);
  EXPECT_TRUE(kernel.parts.empty());
  EXPECT_EQ(static_cast<Index>(kernel.taken.size()), max_clique(graph).upper_bound);
}

TEST(ComplementKernel, OfDisjointCyclesInTheComplementHasAPartEach) {
  BitsetGraph cycles(50);
  for (Index v = 0; v < 50; ++v) cycles.add_edge(v, v % 5 == 4 ? v - 4 : v + 1);
  SearchBudget budget(kForever, 0);
  const BitsetGraph graph = test::complement_of(cycles);
  EXPECT_EQ(reduce_by_complement(graph, budget).parts.size(), 10u);
  EXPECT_EQ(max_clique(graph).vertices.size(), 20u);
}

RC_GTEST_PROP(ComplementSearch, FindsTheCliqueNumberOrProvesThatNoneIsLarger, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 16, 100);
  const Index must_exceed = test::uniform_in(0, 17);
  Incumbent incumbent({0}, must_exceed);
  SearchBudget budget(kForever, kAnyNodes);
  const Index bound = ComplementSearch(graph, incumbent, budget, 1).run();
  const Index clique_number = test::brute_force_clique_number(graph);
  std::vector<Index> clique = incumbent.clique();
  std::sort(clique.begin(), clique.end());
  RC_ASSERT(test::is_ascending_clique(graph, clique));
  RC_ASSERT(std::max(bound, must_exceed) >= clique_number);
  RC_ASSERT(bound <= std::max(clique_number, must_exceed));
  if (clique_number > must_exceed) RC_ASSERT(incumbent.size() == clique_number);
}

TEST(ComplementSearch, EveryNodeBudgetLeavesAValidBound) {
  const BitsetGraph graph = test::random_graph(70, 0.93, 3);
  const Index clique_number = test::cliquer_clique_number(graph);
  for (std::uint64_t max_nodes = 0; max_nodes < 60; ++max_nodes) {
    Incumbent incumbent({0}, 0);
    SearchBudget budget(kForever, max_nodes);
    EXPECT_GE(ComplementSearch(graph, incumbent, budget, 1).run(), clique_number);
    EXPECT_LE(incumbent.size(), clique_number);
  }
}

RC_GTEST_PROP(LocalSearch, KeepsACliqueAndNeverShrinksIt, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 80, 100);
  SearchBudget budget(kForever, 0);
  const std::vector<Index> start{test::uniform_in(0, graph.num_vertices())};
  const std::vector<Index> few = improve_by_swaps(graph, start, 0, budget);
  const std::vector<Index> more = improve_by_swaps(graph, start, 20000, budget);
  RC_ASSERT(test::is_ascending_clique(graph, few));
  RC_ASSERT(test::is_ascending_clique(graph, more));
  RC_ASSERT(more.size() >= few.size());
  RC_ASSERT(!few.empty());
  RC_ASSERT(more == improve_by_swaps(graph, start, 20000, budget));
}

TEST(LocalSearch, FindsTheMaximumCliqueOfASmallDenseGraph) {
  const BitsetGraph graph = test::random_graph(80, 0.9, 11);
  SearchBudget budget(kForever, 0);
  const std::vector<Index> start{0};
  EXPECT_EQ(static_cast<Index>(improve_by_swaps(graph, start, 200000, budget).size()),
            test::cliquer_clique_number(graph));
}

TEST(MaxClique, ProvesTheCliqueOfNoisyInliersThatMissEdges) {
  for (const double tolerance : {2.5, 3.0, 3.5}) {
    const BitsetGraph graph = noisy_inliers(1500, 150, tolerance);
    CliqueOptions options;
    options.max_nodes = 100;
    const CliqueResult result = max_clique(graph, options);
    EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
    EXPECT_TRUE(result.proven_optimal) << tolerance << ": " << result.upper_bound;
  }
}

TEST(MaxClique, BoundsNoisyInliersOfLowToleranceWithinAFewPercent) {
  const BitsetGraph graph = noisy_inliers(1500, 150, 1.5);
  CliqueOptions options;
  options.max_nodes = 100;
  const CliqueResult result = max_clique(graph, options);
  EXPECT_LE(static_cast<double>(result.upper_bound),
            1.1 * static_cast<double>(result.vertices.size()));
}

}  // namespace
}  // namespace gmcr::clique
