#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>

#include "clique/graph/colouring.hpp"
#include "clique/graph/degeneracy.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/search/branch_and_bound.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

/// What any result promises, whatever ended it.
void expect_valid(const BitsetGraph& graph, const CliqueResult& result, Index clique_number,
                  Index must_exceed = 0) {
  const Index size = static_cast<Index>(result.vertices.size());
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_GE(result.upper_bound, size);
  EXPECT_GE(std::max(result.upper_bound, must_exceed), clique_number);
  EXPECT_EQ(result.proven_optimal, result.upper_bound <= std::max(size, must_exceed));
}

TEST(CliqueLimits, EveryNodeBudgetLeavesAValidBound) {
  std::uint64_t seed = 0;
  for (const double density : {0.5, 0.8, 0.95}) {
    const BitsetGraph graph = test::random_graph(90, density, ++seed);
    const Index clique_number = test::cliquer_clique_number(graph);
    const CliqueResult full = max_clique(graph);
    bool ended_early = false;
    CliqueOptions options;
    for (std::uint64_t nodes = 0; nodes < full.nodes + 2; nodes += 1 + nodes / 8) {
      options.max_nodes = nodes;
      const CliqueResult result = max_clique(graph, options);
      expect_valid(graph, result, clique_number);
      EXPECT_LE(result.nodes, nodes);
      ended_early = ended_early || !result.proven_optimal;
    }
    EXPECT_TRUE(ended_early) << "the budget must have been able to bind at density " << density;
  }
}

TEST(CliqueLimits, EveryBudgetOfWorkLeavesAValidBoundTheSameForAnyThreads) {
  const BitsetGraph graph = test::random_graph(200, 0.9, 5);
  const CliqueResult full = [&] {
    CliqueOptions options;
    options.max_nodes = 200'000;
    return max_clique(graph, options);
  }();
  std::uint64_t nodes_before = 0;
  for (const std::uint64_t work : {0u, 1u << 16, 1u << 20, 1u << 24, 1u << 26}) {
    CliqueOptions options;
    options.max_work = work;
    options.num_threads = 1;
    const CliqueResult one = max_clique(graph, options);
    expect_valid(graph, one, static_cast<Index>(full.vertices.size()));
    EXPECT_FALSE(one.proven_optimal);
    EXPECT_GE(one.nodes, nodes_before);
    nodes_before = one.nodes;
    options.num_threads = 4;
    const CliqueResult four = max_clique(graph, options);
    EXPECT_EQ(four.vertices, one.vertices);
    EXPECT_EQ(four.upper_bound, one.upper_bound);
    EXPECT_EQ(four.nodes, one.nodes);
  }
  EXPECT_GT(nodes_before, 100u);
  EXPECT_LT(nodes_before, full.nodes);
}

TEST(CliqueLimits, EveryNodeBudgetOfTheInnerSearchLeavesAValidBound) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const BitsetGraph graph = test::random_graph(18, 0.3 + 0.015 * static_cast<double>(seed), seed);
    const Index clique_number = test::brute_force_clique_number(graph);
    const PackedGraph packed = test::packed(graph);
    BranchAndBound search;
    for (std::uint64_t max_nodes = 0; max_nodes < 40; ++max_nodes) {
      for (const Index to_beat : {0, 3, 6}) {
        SearchBudget budget(1e9, max_nodes);
        search.start(packed, to_beat, budget);
        search.run(budget);
        EXPECT_GE(search.upper_bound(), clique_number > to_beat ? clique_number : to_beat);
        EXPECT_EQ(search.finished(), !budget.spent());
        if (!budget.spent()) {
          EXPECT_EQ(search.upper_bound(), std::max(clique_number, to_beat));
        }
      }
    }
  }
}

TEST(CliqueLimits, NodeBudgetIsDeterministic) {
  const BitsetGraph graph = test::random_graph(200, 0.8, 4);
  CliqueOptions options;
  options.max_nodes = 500;
  const CliqueResult first = max_clique(graph, options);
  const CliqueResult second = max_clique(graph, options);
  EXPECT_FALSE(first.proven_optimal);
  EXPECT_EQ(first.nodes, 500u);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.upper_bound, second.upper_bound);
}

TEST(CliqueLimits, NoTimeReturnsAtOnceWithAValidBound) {
  const BitsetGraph graph = test::random_graph(400, 0.9, 5);
  CliqueOptions options;
  options.time_limit = 0;
  const CliqueResult result = max_clique(graph, options);
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_FALSE(result.vertices.empty());
  EXPECT_FALSE(result.proven_optimal);
  EXPECT_EQ(result.upper_bound, 400);
  EXPECT_EQ(result.nodes, 0u);
}

TEST(CliqueLimits, TimeLimitEndsAHardSearch) {
  const BitsetGraph graph = test::random_graph(600, 0.95, 6);
  CliqueOptions options;
  options.time_limit = 0.2;
  const auto start = std::chrono::steady_clock::now();
  const CliqueResult result = max_clique(graph, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_FALSE(result.proven_optimal);
  EXPECT_GT(result.upper_bound, static_cast<Index>(result.vertices.size()));
  EXPECT_LT(elapsed.count(), 5.0);
}

/// Vertices that agree unless both are poor, as the pairs of many right correspondences do: nearly
/// complete, with a large clique that no cheap bound proves.
BitsetGraph nearly_complete_graph(Index num_vertices, double exponent, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> poorness(num_vertices);
  for (double& p : poorness) p = std::pow(uniform(generator), exponent);
  BitsetGraph graph(num_vertices);
  for (Index u = 0; u < num_vertices; ++u) {
    for (Index v = 0; v < u; ++v) {
      if (uniform(generator) >= poorness[u] * poorness[v]) graph.add_edge(u, v);
    }
  }
  return graph;
}

TEST(CliqueLimits, TimeLimitEndsTheColouringOfALargeNearlyCompleteGraph) {
  const BitsetGraph graph = nearly_complete_graph(6000, 16, 15);
  CliqueOptions options;
  options.time_limit = 0.5;
  const auto start = std::chrono::steady_clock::now();
  const CliqueResult result = max_clique(graph, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed.count(), 5.0);
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_GE(result.upper_bound, static_cast<Index>(result.vertices.size()));
  EXPECT_LT(result.upper_bound, graph.num_vertices());
}

TEST(CliqueLimits, WithoutNodesALargeNearlyCompleteGraphIsBoundedSoon) {
  const BitsetGraph graph = nearly_complete_graph(3000, 16, 16);
  CliqueOptions options;
  options.max_nodes = 0;
  const auto start = std::chrono::steady_clock::now();
  const CliqueResult result = max_clique(graph, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed.count(), 3.0);
  EXPECT_LE(static_cast<double>(result.upper_bound),
            1.1 * static_cast<double>(result.vertices.size()));
}

TEST(CliqueLimits, WorkBeyondTheBudgetLeavesValidBoundsInEveryPart) {
  const Index n = 90;
  const BitsetGraph graph = test::random_graph(n, 0.8, 17);
  const Index clique_number = test::cliquer_clique_number(graph);
  SearchBudget spent(0, 0);
  spent.out_of_time();
  const std::vector<Word> all{~Word{0}, (Word{1} << (n - 64)) - 1};
  const Colouring colouring = colour_greedily(graph, all, {}, &spent);
  EXPECT_EQ(colouring.order.size(), 90u);
  EXPECT_EQ(colouring.colour.back(), colouring.num_colours - 1);
  EXPECT_GE(colouring.num_colours, clique_number);
  const Degeneracy bounds = degeneracy_order(graph, &spent), exact = degeneracy_order(graph);
  EXPECT_EQ(bounds.order.size(), 90u);
  EXPECT_GE(bounds.degeneracy, exact.degeneracy);
  for (Index v = 0; v < n; ++v) EXPECT_GE(bounds.core[v], exact.core[v]) << v;
  BranchAndBound search;
  const PackedGraph packed = test::packed(graph);
  search.start(packed, 3, spent);
  search.run(spent);
  EXPECT_GE(search.upper_bound(), clique_number);
}

TEST(CliqueLimits, MustExceedProvesThatNoLargerCliqueExists) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const BitsetGraph graph = test::random_graph(16, 0.1 + 0.014 * static_cast<double>(seed), seed);
    const Index clique_number = test::brute_force_clique_number(graph);
    for (Index floor = 0; floor <= 18; ++floor) {
      CliqueOptions options;
      options.must_exceed = floor;
      const CliqueResult result = max_clique(graph, options);
      expect_valid(graph, result, clique_number, floor);
      EXPECT_TRUE(result.proven_optimal);
      if (clique_number > floor) {
        EXPECT_EQ(static_cast<Index>(result.vertices.size()), clique_number);
      } else {
        EXPECT_LE(result.upper_bound, floor);
      }
    }
  }
}

TEST(CliqueLimits, MustExceedSavesNodes) {
  const BitsetGraph graph = test::random_graph(150, 0.7, 12);
  const CliqueResult free = max_clique(graph);
  CliqueOptions options;
  options.must_exceed = free.upper_bound + 2;
  EXPECT_LT(max_clique(graph, options).nodes, free.nodes);
}

TEST(CliqueLimits, InitialCliqueIsKeptWhereTimeIsUp) {
  BitsetGraph graph = test::random_graph(300, 0.3, 13);
  CliqueOptions options;
  options.initial_clique = test::plant_clique(graph, 40, 14);
  options.time_limit = 0;
  const std::vector<Index> planted = options.initial_clique;
  std::reverse(options.initial_clique.begin(), options.initial_clique.end());
  EXPECT_EQ(max_clique(graph, options).vertices, planted);
  options.time_limit = 60;
  EXPECT_EQ(max_clique(graph, options).upper_bound, 40);
}

TEST(CliqueLimits, ASmallInitialCliqueDoesNotHideALargerOne) {
  BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{2, 5});
  CliqueOptions options;
  options.initial_clique = {0, 1};
  EXPECT_EQ(max_clique(graph, options).vertices.size(), 5u);
}

TEST(CliqueLimits, AWrongInitialCliqueIsRejected) {
  const BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{2, 2});
  CliqueOptions options;
  for (const auto& wrong : std::vector<std::vector<Index>>{{0, 2}, {0, 0}, {4}, {-1, 0}}) {
    options.initial_clique = wrong;
    EXPECT_THROW(max_clique(graph, options), std::invalid_argument);
  }
}

TEST(CliqueLimits, NoMemoryForCopiesTakesNothingFromTheAnswer) {
  for (const double density : {0.1, 0.6, 0.97}) {
    const BitsetGraph graph = test::random_graph(150, density, 8);
    const CliqueResult copied = max_clique(graph);
    CliqueOptions options;
    options.max_memory = 0;
    const CliqueResult in_place = max_clique(graph, options);
    EXPECT_TRUE(in_place.proven_optimal);
    EXPECT_EQ(in_place.vertices.size(), copied.vertices.size());
    EXPECT_EQ(in_place.upper_bound, copied.upper_bound);
  }
}

TEST(CliqueLimits, OptionsOutOfRangeAreRejectedByName) {
  const auto message_of = [](const CliqueOptions& options) -> std::string {
    try {
      max_clique(BitsetGraph(2), options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CliqueOptions options;
  options.time_limit = -1;
  EXPECT_NE(message_of(options).find("time_limit"), std::string::npos);
  options.time_limit = std::nan("");
  EXPECT_NE(message_of(options).find("time_limit"), std::string::npos);
  options = {};
  options.must_exceed = -3;
  EXPECT_NE(message_of(options).find("must_exceed: -3"), std::string::npos);
}

}  // namespace
}  // namespace gmcr::clique
