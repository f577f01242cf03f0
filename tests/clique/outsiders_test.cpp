// Clique numbers and weights according to igraph and cliquer, on many graphs.
#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <random>

#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "effort.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

BitsetGraph graph_of_pairs(Index n, const std::function<bool(Index, Index)>& is_edge) {
  BitsetGraph graph(n);
  for (Index u = 0; u < n; ++u) {
    for (Index v = u + 1; v < n; ++v) {
      if (is_edge(u, v)) graph.add_edge(u, v);
    }
  }
  return graph;
}

/// igraph takes minutes for graphs with more of the edges.
constexpr double kMostForIgraph = 0.7;

double share_of_edges(const BitsetGraph& graph) {
  const Index n = graph.num_vertices();
  Index num_edges = 0;
  for (Index u = 0; u < n; ++u) {
    for (Index v = u + 1; v < n; ++v) num_edges += graph.has_edge(u, v);
  }
  return n < 2 ? 0 : 2 * static_cast<double>(num_edges) / static_cast<double>(n * (n - 1));
}

double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

/// Up to 70 vertices, a third of them with a planted clique or with blocks.
BitsetGraph any_graph(std::mt19937_64& generator) {
  const Index n = 1 + static_cast<Index>(generator() % 70);
  const double most_dense = n < 40 ? 1 : n < 55 ? 0.9 : 0.75;
  const double density = most_dense * uniform(generator);
  BitsetGraph graph = test::random_graph(n, density, generator());
  const auto kind = generator() % 6;
  if (kind == 0) {
    const auto size = 1 + generator() % static_cast<std::uint64_t>(n);
    test::plant_clique(graph, static_cast<Index>(size), generator());
  }
  if (kind == 1) {
    const Index parts = 1 + static_cast<Index>(generator() % 9);
    return graph_of_pairs(n, [&](Index u, Index v) {
      return u % parts != v % parts || uniform(generator) < density / 4;
    });
  }
  return graph;
}

void expect_the_same(const BitsetGraph& graph, const std::string& name) {
  const CliqueResult found = max_clique(graph);
  ASSERT_TRUE(found.proven_optimal) << name;
  ASSERT_TRUE(test::is_ascending_clique(graph, found.vertices)) << name;
  ASSERT_EQ(static_cast<Index>(found.vertices.size()), test::cliquer_clique_number(graph)) << name;
}

TEST(Outsiders, AgreeOnTheCliquesOfRandomGraphs) {
  std::mt19937_64 generator(7);
  for (int i = 0; i < 250 * test::effort(); ++i) {
    const BitsetGraph graph = any_graph(generator);
    expect_the_same(graph, "graph " + std::to_string(i));
    if (share_of_edges(graph) > kMostForIgraph) continue;
    ASSERT_EQ(test::igraph_clique_number(graph), test::cliquer_clique_number(graph)) << i;
  }
}

TEST(Outsiders, AgreeOnTheWeightsOfRandomGraphs) {
  std::mt19937_64 generator(8);
  for (int i = 0; i < 250 * test::effort(); ++i) {
    const BitsetGraph graph = any_graph(generator);
    const int largest = 1 << (generator() % 12);
    std::vector<int> weights;
    for (Index v = 0; v < graph.num_vertices(); ++v) {
      weights.push_back(1 + static_cast<int>(generator() % static_cast<std::uint64_t>(largest)));
    }
    const std::vector<double> as_doubles(weights.begin(), weights.end());
    const WeightedCliqueResult found = max_weight_clique(graph, as_doubles);
    ASSERT_TRUE(found.proven_optimal) << i;
    ASSERT_EQ(found.weight, static_cast<double>(test::cliquer_clique_weight(graph, weights))) << i;
    ASSERT_EQ(found.upper_bound, found.weight) << i;
  }
}

BitsetGraph hamming(int bits, int distance) {
  return graph_of_pairs(Index{1} << bits, [=](Index u, Index v) {
    return std::popcount(static_cast<std::uint64_t>(u ^ v)) >= distance;
  });
}

BitsetGraph johnson(int bits, int weight, int distance) {
  std::vector<std::uint64_t> words;
  for (std::uint64_t word = 0; word < std::uint64_t{1} << bits; ++word) {
    if (std::popcount(word) == weight) words.push_back(word);
  }
  return graph_of_pairs(static_cast<Index>(words.size()), [&](Index u, Index v) {
    return std::popcount(words[static_cast<std::size_t>(u)] ^ words[static_cast<std::size_t>(v)]) >=
           distance;
  });
}

/// "c-fat": rings of parts, each a neighbour of the next.
BitsetGraph fat_ring(Index n, Index parts) {
  return graph_of_pairs(n, [=](Index u, Index v) {
    const Index apart = ((u % parts) - (v % parts) + parts) % parts;
    return apart <= 1 || apart == parts - 1;
  });
}

/// "p_hat": the density differs from vertex to vertex.
BitsetGraph uneven(Index n, double low, double high, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> share;
  for (Index v = 0; v < n; ++v) share.push_back(low + (high - low) * uniform(generator));
  return graph_of_pairs(n, [&](Index u, Index v) {
    return uniform(generator) <
           (share[static_cast<std::size_t>(u)] + share[static_cast<std::size_t>(v)]) / 2;
  });
}

/// "MANN": the complement of disjoint triangles, each with a vertex tied to those of its block.
BitsetGraph nearly_complete(Index blocks) {
  return graph_of_pairs(4 * blocks, [](Index u, Index v) {
    return u / 4 != v / 4 && !(u % 4 == 3 && v % 4 == 3 && u / 4 / 3 == v / 4 / 3);
  });
}

/// "brock": a hidden clique whose members have no more neighbours than the others.
BitsetGraph hidden(Index n, double density, Index size, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const double k = static_cast<double>(size), all = static_cast<double>(n);
  const double to_rest = (density * (all - 1) - (k - 1)) / (all - k);
  return graph_of_pairs(n, [&](Index u, Index v) {
    return v < size || uniform(generator) < (u < size ? to_rest : density);
  });
}

/// "san": independent sets, with a clique of one vertex of each.
BitsetGraph of_parts(Index n, double density, Index parts, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  return graph_of_pairs(n, [&](Index u, Index v) {
    return v < parts || (u % parts != v % parts && uniform(generator) < density);
  });
}

TEST(Outsiders, AgreeOnFamiliesOfTheDimacsChallenge) {
  // of what takes cliquer too long the size is known
  const auto expect = [](const BitsetGraph& graph, const std::string& name, Index known = 0) {
    if (known == 0) return expect_the_same(graph, name);
    EXPECT_EQ(static_cast<Index>(max_clique(graph).vertices.size()), known) << name;
  };
  expect(hamming(6, 2), "hamming6-2", 32);
  expect(hamming(6, 4), "hamming6-4", 4);
  expect(hamming(8, 2), "hamming8-2", 128);
  expect(hamming(8, 4), "hamming8-4", 16);
  expect(johnson(8, 2, 4), "johnson8-2-4", 4);
  expect(johnson(8, 4, 4), "johnson8-4-4", 14);
  expect(johnson(16, 2, 4), "johnson16-2-4", 8);
  for (const Index parts : {5, 10, 20}) expect(fat_ring(200, parts), "c-fat", 2 * 200 / parts);
  for (int i = 0; i < 3 * test::effort(); ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    expect(uneven(100, 0, 0.5, seed), "p_hat-1");
    expect(uneven(80, 0.25, 0.75, seed), "p_hat-2");
    expect(hidden(80, 0.65, 11, seed), "brock");
    expect(of_parts(90, 0.6, 12, seed), "san");
    expect(test::random_graph(100, 0.5, seed), "C");
  }
  for (const Index blocks : {2, 3, 4}) expect(nearly_complete(blocks), "MANN");
}

}  // namespace
}  // namespace gmcr::clique
