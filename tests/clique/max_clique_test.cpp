#include <gtest/gtest.h>

#include "clique/arbitrary.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

/// Size of the clique found, once it is verified and proven.
Index proven_size(const BitsetGraph& graph, const CliqueOptions& options = {}) {
  const CliqueResult result = max_clique(graph, options);
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_TRUE(result.proven_optimal);
  EXPECT_EQ(result.upper_bound, static_cast<Index>(result.vertices.size()));
  return static_cast<Index>(result.vertices.size());
}

TEST(MaxClique, OfNoVerticesIsEmptyAndProven) { EXPECT_EQ(proven_size(BitsetGraph(0)), 0); }

TEST(MaxClique, OfAGraphWithoutEdgesIsOneVertex) {
  for (const Index n : {1, 2, 3, 63, 64, 65, 127, 128, 511, 512, 513}) {
    EXPECT_EQ(proven_size(BitsetGraph(n)), 1) << n;
  }
}

TEST(MaxClique, OfTwoDisjointTrianglesIsOneTriangle) {
  const CliqueResult result = max_clique(test::disjoint_cliques(std::vector<Index>{3, 3}));
  EXPECT_TRUE(result.vertices == (std::vector<Index>{0, 1, 2}) ||
              result.vertices == (std::vector<Index>{3, 4, 5}));
}

TEST(MaxClique, OfDisjointCliquesIsTheLargest) {
  EXPECT_EQ(proven_size(test::disjoint_cliques(std::vector<Index>{4, 9, 30, 29, 1, 30})), 30);
}

TEST(MaxClique, OfACompleteGraphIsAllOfIt) {
  for (const Index n : {1, 2, 3, 63, 64, 65, 127, 128, 511, 512, 513, 2000}) {
    EXPECT_EQ(proven_size(test::complete_graph(n)), n);
  }
}

TEST(MaxClique, OfTheComplementOfAPerfectMatchingIsHalf) {
  for (const Index n : {2, 64, 66, 500, 1026}) {
    EXPECT_EQ(proven_size(test::complete_multipartite_graph(n, n / 2)), n / 2);
  }
}

TEST(MaxClique, OfATuranGraphIsItsNumberOfParts) {
  for (const Index parts : {1, 2, 3, 7, 40}) {
    EXPECT_EQ(proven_size(test::complete_multipartite_graph(200, parts)), parts);
  }
}

TEST(MaxClique, OfAMycielskiGraphIsAnEdgeAlthoughItNeedsManyColours) {
  BitsetGraph graph = test::complete_graph(2);
  for (int colors = 3; colors <= 8; ++colors) graph = test::mycielskian(graph);
  EXPECT_EQ(graph.num_vertices(), 191);
  EXPECT_EQ(proven_size(graph), 2);
}

TEST(MaxClique, AgreesWithBruteForceOnSmallGraphsOfEveryDensity) {
  std::uint64_t seed = 0;
  for (Index n = 1; n <= 16; ++n) {
    for (int percent = 0; percent <= 100; percent += 5) {
      for (int repeat = 0; repeat < 3; ++repeat) {
        const BitsetGraph graph = test::random_graph(n, percent / 100.0, ++seed);
        ASSERT_EQ(proven_size(graph), test::brute_force_clique_number(graph)) << seed;
      }
    }
  }
}

TEST(MaxClique, AgreesWithIgraphAndCliquer) {
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
                                   {100, 0.5},
                                   {128, 0.4},
                                   {129, 0.3},
                                   {300, 0.1},
                                   {511, 0.05},
                                   {512, 0.05},
                                   {513, 0.05}}) {
    for (int repeat = 0; repeat < 3; ++repeat) {
      const BitsetGraph graph = test::random_graph(n, density, ++seed);
      const Index size = proven_size(graph);
      EXPECT_EQ(size, test::cliquer_clique_number(graph)) << n << " " << density << " " << seed;
      if (density < 0.8) {
        EXPECT_EQ(size, test::igraph_clique_number(graph)) << seed;
      }
    }
  }
}

TEST(MaxClique, OfALargeStarIsProvenWithoutASearch) {
  BitsetGraph star(500);
  for (Index v = 1; v < 500; ++v) star.add_edge(0, v);
  CliqueOptions options;
  options.must_exceed = 2;
  const CliqueResult result = max_clique(star, options);
  EXPECT_TRUE(result.proven_optimal);
  EXPECT_EQ(result.upper_bound, 2);
  EXPECT_EQ(result.nodes, 0u);
}

TEST(MaxClique, FindsAPlantedCliqueInALargeSparseGraph) {
  for (const Index size : {20, 60, 250}) {
    BitsetGraph graph = test::random_graph(3000, 0.05, 7);
    const std::vector<Index> planted = test::plant_clique(graph, size, 8);
    EXPECT_EQ(max_clique(graph).vertices, planted);
  }
}

TEST(MaxClique, CertifiesGoodDataWithAFewStrays) {
  // 950 correspondences agree; each of 50 strays agrees with half of them.
  const Index num_good = 950, num_stray = 50;
  BitsetGraph graph = test::random_graph(num_good + num_stray, 0.5, 9);
  for (Index u = 0; u < num_good; ++u) {
    for (Index v = 0; v < u; ++v) graph.add_edge(u, v);
  }
  EXPECT_EQ(proven_size(graph), num_good);
}

TEST(MaxClique, SolvesAGraphWhoseComplementIsSparse) {
  // The complement is a path: every other vertex.
  const Index n = 301;
  BitsetGraph path(n);
  for (Index v = 1; v < n; ++v) path.add_edge(v - 1, v);
  EXPECT_EQ(proven_size(test::complement_of(path)), 151);
}

RC_GTEST_PROP(MaxClique, DoesNotDependOnTheNumbersOfTheVertices, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 90, 80);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const BitsetGraph shuffled =
      test::renumbered(graph, test::random_permutation(graph.num_vertices(), seed));
  RC_ASSERT(proven_size(graph) == proven_size(shuffled));
}

RC_GTEST_PROP(MaxClique, NeverShrinksWhenAnEdgeIsAdded, ()) {
  BitsetGraph graph = test::arbitrary_graph(2, 60, 90);
  const Index before = proven_size(graph);
  const Index u = test::uniform_in(1, graph.num_vertices());
  graph.add_edge(u, test::uniform_in(0, u));
  const Index after = proven_size(graph);
  RC_ASSERT(after >= before);
  RC_ASSERT(after <= before + 1);
}

TEST(MaxClique, GivesTheSameVerticesAndNodesEachTime) {
  const BitsetGraph graph = test::random_graph(150, 0.7, 3);
  const CliqueResult first = max_clique(graph);
  const CliqueResult second = max_clique(graph);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_GT(first.nodes, 0u);
}

}  // namespace
}  // namespace gmcr::clique
