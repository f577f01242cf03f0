#include <gtest/gtest.h>

#include <numeric>

#include "clique/arbitrary.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/weights.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

constexpr double kRounding = 1e-11;

/// Weight of the clique found, once it is verified and proven.
double proven_weight(const BitsetGraph& graph, const std::vector<double>& weights) {
  const WeightedCliqueResult result = max_weight_clique(graph, weights);
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  double sum = 0;
  for (const Index v : result.vertices) sum += weights[static_cast<std::size_t>(v)];
  EXPECT_EQ(result.weight, sum);
  EXPECT_TRUE(result.proven_optimal);
  EXPECT_GE(result.upper_bound, result.weight);
  EXPECT_LE(result.upper_bound, result.weight * (1 + kRounding));
  return result.weight;
}

std::vector<double> as_doubles(const std::vector<int>& weights) {
  return {weights.begin(), weights.end()};
}

TEST(MaxWeightClique, OfNoVerticesIsEmptyAndProven) {
  EXPECT_EQ(proven_weight(BitsetGraph(0), {}), 0);
}

TEST(MaxWeightClique, OfAGraphWithoutEdgesIsTheHeaviestVertex) {
  for (const Index n : {1, 2, 3, 63, 64, 65, 127, 128, 513}) {
    std::vector<double> weights(static_cast<std::size_t>(n), 0.25);
    weights.back() = 0.75;
    const WeightedCliqueResult result = max_weight_clique(BitsetGraph(n), weights);
    EXPECT_EQ(result.vertices, std::vector<Index>{n - 1});
    EXPECT_EQ(proven_weight(BitsetGraph(n), weights), 0.75);
  }
}

TEST(MaxWeightClique, OfTwoDisjointTrianglesIsTheHeavier) {
  const BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{3, 3});
  const std::vector<double> weights{1, 1, 1, 0.5, 2, 1};
  EXPECT_EQ(max_weight_clique(graph, weights).vertices, (std::vector<Index>{3, 4, 5}));
}

TEST(MaxWeightClique, PrefersAFewHeavyVerticesToManyLightOnes) {
  const BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{30, 3});
  std::vector<double> weights(33, 1.0 / 30);
  weights[30] = weights[31] = weights[32] = 1;
  EXPECT_EQ(max_weight_clique(graph, weights).vertices, (std::vector<Index>{30, 31, 32}));
}

TEST(MaxWeightClique, OfACompleteGraphIsAllOfIt) {
  for (const Index n : {1, 2, 3, 63, 64, 65, 128, 513, 2000}) {
    const std::vector<double> weights = test::cluster_weights(n, 1);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    EXPECT_EQ(proven_weight(test::complete_graph(n), weights), sum) << n;
  }
}

TEST(MaxWeightClique, LeavesVerticesWithoutWeightOut) {
  const BitsetGraph graph = test::complete_graph(70);
  std::vector<double> weights(70, 0.0);
  EXPECT_EQ(proven_weight(graph, weights), 0);
  EXPECT_TRUE(max_weight_clique(graph, weights).vertices.empty());
  weights[3] = weights[66] = 1;
  EXPECT_EQ(max_weight_clique(graph, weights).vertices, (std::vector<Index>{3, 66}));
}

TEST(MaxWeightClique, AgreesWithBruteForceOnSmallGraphsOfEveryDensity) {
  std::uint64_t seed = 0;
  for (Index n = 1; n <= 14; ++n) {
    for (int percent = 0; percent <= 100; percent += 5) {
      for (int repeat = 0; repeat < 3; ++repeat) {
        const BitsetGraph graph = test::random_graph(n, percent / 100.0, ++seed);
        const std::vector<double> weights = test::cluster_weights(n, seed);
        const double expected = test::brute_force_clique_weight(graph, weights);
        ASSERT_NEAR(proven_weight(graph, weights), expected, kRounding * expected) << seed;
      }
    }
  }
}

TEST(MaxWeightClique, AgreesWithCliquer) {
  struct Case {
    Index n;
    double density;
  };
  std::uint64_t seed = 100;
  for (const auto& [n, density] : {Case{40, 0.9},
                                   {60, 0.8},
                                   {63, 0.7},
                                   {64, 0.7},
                                   {65, 0.7},
                                   {128, 0.4},
                                   {129, 0.3},
                                   {300, 0.1},
                                   {513, 0.05}}) {
    for (const int max_weight : {2, 12, 1000}) {
      const BitsetGraph graph = test::random_graph(n, density, ++seed);
      const std::vector<int> weights = test::whole_weights(n, max_weight, seed);
      EXPECT_EQ(proven_weight(graph, as_doubles(weights)),
                static_cast<double>(test::cliquer_clique_weight(graph, weights)))
          << n << " " << density << " " << seed;
    }
  }
}

TEST(MaxWeightClique, WithEqualWeightsAgreesWithTheMaximumClique) {
  for (const double weight : {1.0, 1.0 / 3}) {
    for (const double density : {0.05, 0.3, 0.7, 0.9}) {
      const Index n = density < 0.8 ? 130 : 70;
      const BitsetGraph graph = test::random_graph(n, density, 11);
      const auto size = static_cast<double>(max_clique(graph).upper_bound);
      const std::vector<double> weights(static_cast<std::size_t>(n), weight);
      EXPECT_NEAR(proven_weight(graph, weights), size * weight, kRounding * size);
    }
  }
}

TEST(MaxWeightClique, OfUnitWeightsIsBoundedByItsSizeExactly) {
  const BitsetGraph graph = test::random_graph(100, 0.4, 12);
  const WeightedCliqueResult result = max_weight_clique(graph, std::vector<double>(100, 1.0));
  EXPECT_EQ(result.upper_bound, static_cast<double>(result.vertices.size()));
}

TEST(MaxWeightClique, FindsAPlantedCliqueInALargeSparseGraph) {
  for (const Index size : {20, 60, 250}) {
    BitsetGraph graph = test::random_graph(3000, 0.05, 7);
    const std::vector<Index> planted = test::plant_clique(graph, size, 8);
    std::vector<double> weights = test::cluster_weights(3000, 9);
    for (const Index v : planted) weights[static_cast<std::size_t>(v)] = 1;
    const WeightedCliqueResult result = max_weight_clique(graph, weights);
    EXPECT_EQ(result.vertices, planted);
    EXPECT_TRUE(result.proven_optimal);
  }
}

TEST(MaxWeightClique, CertifiesGoodDataWithAFewStrays) {
  const Index num_good = 950, num_stray = 50;
  BitsetGraph graph = test::random_graph(num_good + num_stray, 0.5, 9);
  for (Index u = 0; u < num_good; ++u) {
    for (Index v = 0; v < u; ++v) graph.add_edge(u, v);
  }
  const std::vector<double> weights = test::cluster_weights(num_good + num_stray, 9);
  const double good = std::accumulate(weights.begin(), weights.begin() + num_good, 0.0);
  EXPECT_NEAR(proven_weight(graph, weights), good, 1e-9);
}

TEST(MaxWeightClique, IsExactForWeightsOfAnySize) {
  BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{2, 2});
  EXPECT_EQ(proven_weight(graph, {1e-300, 1e300, 1e299, 5e299}), 1e300);
  EXPECT_EQ(proven_weight(graph, {1e-300, 2e-300, 3e-300, 1e-301}), 3.1e-300);
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(proven_weight(graph, {tiny, tiny, tiny, 0}), 2 * tiny);
}

RC_GTEST_PROP(MaxWeightClique, DoesNotDependOnTheNumbersOfTheVertices, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 90, 80);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const std::vector<Index> number = test::random_permutation(graph.num_vertices(), seed);
  const std::vector<double> weights = test::cluster_weights(graph.num_vertices(), seed);
  std::vector<double> shuffled(weights.size());
  for (std::size_t v = 0; v < weights.size(); ++v) {
    shuffled[static_cast<std::size_t>(number[v])] = weights[v];
  }
  const double expected = proven_weight(graph, weights);
  const double found = proven_weight(test::renumbered(graph, number), shuffled);
  RC_ASSERT(std::abs(found - expected) <= kRounding * expected);
}

RC_GTEST_PROP(MaxWeightClique, ScalesWithTheWeights, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 60, 90);
  std::vector<double> weights =
      test::cluster_weights(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const WeightedCliqueResult before = max_weight_clique(graph, weights);
  for (double& weight : weights) weight *= 1024;
  const WeightedCliqueResult after = max_weight_clique(graph, weights);
  RC_ASSERT(after.vertices == before.vertices);
  RC_ASSERT(after.upper_bound == 1024 * before.upper_bound);
}

RC_GTEST_PROP(MaxWeightClique, NeverGetsLighterWhenAVertexGetsHeavier, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 60, 90);
  std::vector<double> weights =
      test::cluster_weights(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const double before = proven_weight(graph, weights);
  weights[static_cast<std::size_t>(test::uniform_in(0, graph.num_vertices()))] += 0.5;
  const double after = proven_weight(graph, weights);
  RC_ASSERT(after >= before * (1 - kRounding));
  RC_ASSERT(after <= (before + 0.5) * (1 + kRounding));
}

TEST(MaxWeightClique, GivesTheSameVerticesAndNodesEachTime) {
  const BitsetGraph graph = test::random_graph(150, 0.7, 3);
  const std::vector<double> weights = test::cluster_weights(150, 4);
  const WeightedCliqueResult first = max_weight_clique(graph, weights);
  const WeightedCliqueResult second = max_weight_clique(graph, weights);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_GT(first.nodes, 0u);
}

}  // namespace
}  // namespace gmcr::clique
