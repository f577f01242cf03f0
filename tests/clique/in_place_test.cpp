// Large parts of a graph are searched in a renumbered copy where memory suffices, in place
// otherwise.
#include <gtest/gtest.h>

#include <random>

#include "clique/clique.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/survivor_search.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

CliqueResult solve(const BitsetGraph& graph, std::size_t max_memory) {
  CliqueOptions options;
  options.max_memory = max_memory;
  return max_clique(graph, options);
}

/// The number of vertices whose copy is the first that is made as the memory grows, judged by the
/// nodes of the search, which differ between a copy and the graph itself.
Index first_copied(const BitsetGraph& graph) {
  const std::uint64_t nodes_of_copy = max_clique(graph).nodes;
  Index below = 0, enough = graph.num_vertices();
  while (enough - below > 1) {
    const Index middle = (below + enough) / 2;
    const bool copies = solve(graph, PackedGraph::bytes_required(middle)).nodes == nodes_of_copy;
    (copies ? enough : below) = middle;
  }
  return enough;
}

struct PlantedCase {
  Index num_vertices;
  double density;
  Index planted;  ///< vertices of the one maximum clique; 0: as it comes
};

const std::vector<PlantedCase> kCases{{300, 0.1, 0},  {200, 0.3, 10}, {150, 0.5, 0},
                                      {120, 0.7, 18}, {100, 0.8, 0},  {90, 0.9, 0}};

BitsetGraph graph_of(const PlantedCase& wanted, std::uint64_t seed) {
  BitsetGraph graph = test::random_graph(wanted.num_vertices, wanted.density, seed);
  if (wanted.planted > 0) test::plant_clique(graph, wanted.planted, seed + 1);
  return graph;
}

void expect_the_same_answer(const CliqueResult& in_place, const CliqueResult& copied) {
  EXPECT_TRUE(in_place.proven_optimal);
  EXPECT_EQ(in_place.proven_optimal, copied.proven_optimal);
  EXPECT_EQ(in_place.upper_bound, copied.upper_bound);
  EXPECT_EQ(in_place.vertices.size(), copied.vertices.size());
}

TEST(CliqueInPlace, AByteTooLittleForTheCopyTakesNothingFromTheAnswer) {
  int num_in_place = 0;
  for (const PlantedCase& wanted : kCases) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const BitsetGraph graph = graph_of(wanted, seed);
      const CliqueResult copied = max_clique(graph);
      const std::size_t bytes = PackedGraph::bytes_required(first_copied(graph));
      const CliqueResult at = solve(graph, bytes), below = solve(graph, bytes - 1);
      EXPECT_EQ(at.vertices, copied.vertices);
      EXPECT_EQ(at.nodes, copied.nodes);
      expect_the_same_answer(at, copied);
      expect_the_same_answer(below, copied);
      EXPECT_TRUE(test::is_ascending_clique(graph, below.vertices));
      if (wanted.planted > 0) {
        EXPECT_EQ(below.vertices, copied.vertices);
      }
      num_in_place += below.nodes != copied.nodes;
    }
  }
  EXPECT_GT(num_in_place, 10);
}

TEST(CliqueInPlace, NeitherDoesAnyAmountOfMemoryWhereFewVerticesSurvive) {
  // a dense part among vertices of degree 0 to 2, which the degrees drop
  const Index num_dense = 120, n = 400;
  const BitsetGraph dense = test::random_graph(num_dense, 0.7, 3);
  BitsetGraph graph(n);
  for (Index u = 0; u < num_dense; ++u) {
    for (Index v = 0; v < u; ++v) {
      if (dense.has_edge(u, v)) graph.add_edge(3 * u, 3 * v);
    }
  }
  for (Index u = 0; u + 1 < n; u += 5) graph.add_edge(u, u + 1);
  const CliqueResult copied = max_clique(graph);
  EXPECT_EQ(copied.upper_bound, test::cliquer_clique_number(dense));
  for (Index count = 1; count < n; count += 23) {
    for (const std::size_t bytes :
         {BitsetGraph::bytes_required(count), PackedGraph::bytes_required(count)}) {
      expect_the_same_answer(solve(graph, bytes), copied);
      expect_the_same_answer(solve(graph, bytes - 1), copied);
    }
  }
}

TEST(CliqueInPlace, DeadlinesAndNodeBudgetsLeaveValidBounds) {
  bool ended_early = false;
  for (const PlantedCase& wanted : kCases) {
    const BitsetGraph graph = graph_of(wanted, 17);
    const Index clique_number = test::cliquer_clique_number(graph);
    for (const int num_threads : {1, 3}) {
      CliqueOptions options;
      options.num_threads = num_threads;
      options.max_memory = PackedGraph::bytes_required(first_copied(graph)) - 1;
      const auto check = [&] {
        const CliqueResult result = max_clique(graph, options);
        const Index size = static_cast<Index>(result.vertices.size());
        EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
        EXPECT_LE(size, clique_number);
        EXPECT_GE(result.upper_bound, clique_number);
        EXPECT_EQ(result.proven_optimal, size == result.upper_bound);
        EXPECT_LE(result.nodes, options.max_nodes);
        ended_early = ended_early || !result.proven_optimal;
      };
      for (const double seconds : {0.0, 1e-5, 1e-4, 1e-3, 1e-2}) {
        options.time_limit = seconds;
        check();
      }
      options.time_limit = 60;
      for (const std::uint64_t max_nodes : {0u, 1u, 10u, 100u, 1000u}) {
        options.max_nodes = max_nodes;
        check();
      }
    }
  }
  EXPECT_TRUE(ended_early);
}

TEST(CliqueInPlace, AnyNumberOfThreadsGivesTheSame) {
  for (const PlantedCase& wanted : kCases) {
    const BitsetGraph graph = graph_of(wanted, 29);
    CliqueOptions options;
    options.max_memory = 0;
    options.num_threads = 1;
    const CliqueResult one = max_clique(graph, options);
    options.num_threads = 4;
    const CliqueResult several = max_clique(graph, options);
    EXPECT_EQ(several.vertices, one.vertices);
    EXPECT_EQ(several.nodes, one.nodes);
  }
}

/// Each pair of many vertices is an edge with a small probability.
BitsetGraph sparse_graph(Index num_vertices, double density, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::geometric_distribution<Index> gap(density);
  BitsetGraph graph(num_vertices);
  for (Index u = 1; u < num_vertices; ++u) {
    for (Index v = gap(generator); v < u; v += 1 + gap(generator)) graph.add_edge(u, v);
  }
  return graph;
}

/// Maximum over the vertices of the clique number of those of their neighbours that come later,
/// each searched in a copy.
Index clique_number_by_neighbourhoods(const BitsetGraph& graph) {
  const std::vector<Index> order = degeneracy_order(graph).order;
  std::vector<Index> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
  }
  Index largest = 1;
  std::vector<Index> later;
  for (const Index v : order) {
    later.clear();
    for_each_bit(graph.row(v).data(), graph.words_per_row(), [&](Index u) {
      if (place[static_cast<std::size_t>(u)] > place[static_cast<std::size_t>(v)]) {
        later.push_back(u);
      }
    });
    if (static_cast<Index>(later.size()) < largest) continue;
    largest = std::max(largest, 1 + max_clique(induced_subgraph(graph, later)).upper_bound);
  }
  return largest;
}

// A copy of more than 64 MiB is not made where most vertices survive, whatever the memory.
TEST(CliqueInPlace, ALargeGraphOfWhichMostSurvivesIsSearchedAsWell) {
  const Index num_vertices = 24000;
  const BitsetGraph graph = sparse_graph(num_vertices, 0.002, 5);
  const CliqueResult result = max_clique(graph);
  EXPECT_TRUE(result.proven_optimal);
  EXPECT_GT(result.nodes, 0u);
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_EQ(result.upper_bound, clique_number_by_neighbourhoods(graph));
  CliqueOptions options;
  for (const double seconds : {0.0, 0.01, 0.05}) {
    options.time_limit = seconds;
    const CliqueResult early = max_clique(graph, options);
    EXPECT_TRUE(test::is_ascending_clique(graph, early.vertices));
    EXPECT_GE(early.upper_bound, result.upper_bound);
  }
}

}  // namespace
}  // namespace gmcr::clique
