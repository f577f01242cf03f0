#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <stop_token>
#include <string>
#include <thread>

#include "clique/arbitrary.hpp"
#include "clique/graph/core_filter.hpp"
#include "clique/graph/degrees.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/weights.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

CliqueResult solve(const BitsetGraph& graph, CliqueOptions options, int num_threads) {
  options.num_threads = num_threads;
  return max_clique(graph, options);
}

void expect_same_for_any_number_of_threads(const BitsetGraph& graph, const CliqueOptions& options) {
  const CliqueResult one = solve(graph, options, 1);
  for (const int num_threads : {0, 2, 5}) {
    const CliqueResult several = solve(graph, options, num_threads);
    EXPECT_EQ(one.vertices, several.vertices) << num_threads;
    EXPECT_EQ(one.upper_bound, several.upper_bound) << num_threads;
    EXPECT_EQ(one.proven_optimal, several.proven_optimal) << num_threads;
    EXPECT_EQ(one.nodes, several.nodes) << num_threads;
  }
}

TEST(CliqueThreads, AnyNumberGivesTheSameResultAndNodes) {
  expect_same_for_any_number_of_threads(test::random_graph(300, 0.6, 1), {});
  expect_same_for_any_number_of_threads(test::random_graph(150, 0.9, 2), {});
  expect_same_for_any_number_of_threads(test::random_graph(1500, 0.2, 3), {});
}

TEST(CliqueThreads, NodeBudgetsAreKeptExactlyWithAnyNumber) {
  const BitsetGraph graph = test::random_graph(250, 0.8, 4);
  CliqueOptions options;
  for (const std::uint64_t max_nodes : {1u, 17u, 1000u, 60000u}) {
    options.max_nodes = max_nodes;
    expect_same_for_any_number_of_threads(graph, options);
    EXPECT_EQ(solve(graph, options, 5).nodes, max_nodes);
  }
}

TEST(CliqueThreads, LimitsHoldWithMany) {
  BitsetGraph graph = test::random_graph(600, 0.9, 5);
  const std::vector<Index> planted = test::plant_clique(graph, 100, 6);
  CliqueOptions options;
  for (const double seconds : {0.0, 1e-4, 0.01, 0.3}) {
    options.time_limit = seconds;
    const auto start = std::chrono::steady_clock::now();
    const CliqueResult result = solve(graph, options, 16);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_LT(elapsed.count(), seconds + 3);
    EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
    EXPECT_GE(result.upper_bound, static_cast<Index>(planted.size()));
  }
}

TEST(CliqueThreads, AnyNumberGivesTheSameHeaviestCliqueAndNodes) {
  // large enough that the sums over neighbourhoods are shared among threads
  const BitsetGraph graph = test::random_graph(6000, 0.05, 8);
  const std::vector<double> weights = test::cluster_weights(6000, 9);
  for (const std::uint64_t max_work : {std::uint64_t{1} << 18, std::uint64_t{1} << 25}) {
    WeightedCliqueOptions options;
    options.max_work = max_work;
    options.num_threads = 1;
    const WeightedCliqueResult one = max_weight_clique(graph, weights, options);
    for (const int num_threads : {0, 2, 5}) {
      options.num_threads = num_threads;
      const WeightedCliqueResult several = max_weight_clique(graph, weights, options);
      EXPECT_EQ(one.vertices, several.vertices) << num_threads;
      EXPECT_EQ(one.upper_bound, several.upper_bound) << num_threads;
      EXPECT_EQ(one.nodes, several.nodes) << num_threads;
    }
  }
}

TEST(CliqueThreads, ARequestToStopEndsHardSearchesWithValidBounds) {
  BitsetGraph graph = test::random_graph(600, 0.9, 5);
  const auto planted = static_cast<Index>(test::plant_clique(graph, 100, 6).size());
  std::stop_source source;
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    source.request_stop();
  });
  const auto start = std::chrono::steady_clock::now();
  CliqueOptions options;
  options.stop = source.get_token();
  const CliqueResult largest = max_clique(graph, options);
  WeightedCliqueOptions weighted_options;
  weighted_options.stop = source.get_token();
  const auto weights = test::cluster_weights(600, 6);
  const WeightedCliqueResult heaviest = max_weight_clique(graph, weights, weighted_options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed.count(), 5);
  EXPECT_FALSE(largest.proven_optimal);
  EXPECT_GE(largest.upper_bound, planted);
  EXPECT_FALSE(heaviest.proven_optimal);
  EXPECT_GE(heaviest.upper_bound, heaviest.weight);
}

template <class Options>
void expect_wrong_numbers_of_threads_are_named() {
  for (const int wrong : {-1, 1025}) {
    Options options;
    options.num_threads = wrong;
    try {
      options.validate();
      FAIL() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("num_threads: " + std::to_string(wrong)),
                std::string::npos);
    }
  }
}

TEST(CliqueThreads, NumbersOutOfRangeAreRejectedByName) {
  expect_wrong_numbers_of_threads_are_named<CliqueOptions>();
  expect_wrong_numbers_of_threads_are_named<WeightedCliqueOptions>();
}

TEST(MaxCliqueOfALargeGraph, FindsAPlantedCliqueAmongManySparseVertices) {
  const Index n = 20000;
  BitsetGraph graph(n);
  std::mt19937_64 generator(7);
  for (Index k = 0; k < 40 * n; ++k) {
    const Index u = static_cast<Index>(generator() % n), v = static_cast<Index>(generator() % n);
    if (u != v) graph.add_edge(u, v);
  }
  const std::vector<Index> planted = test::plant_clique(graph, 25, 8);
  const CliqueResult result = max_clique(graph);
  EXPECT_EQ(result.vertices, planted);
  EXPECT_TRUE(result.proven_optimal);
}

TEST(MaxCliqueOfALargeGraph, IsAllOfACompleteOne) {
  EXPECT_EQ(max_clique(test::complete_graph(5000)).upper_bound, 5000);
}

TEST(CoreFilter, KeepsTheCoreAndDropsATail) {
  // a clique of 70, whose last vertex starts a path that a filter by degree eats up
  std::vector<Index> sizes(131, 1);
  sizes[0] = 70;
  BitsetGraph graph = test::disjoint_cliques(sizes);
  for (Index v = 70; v < 200; ++v) graph.add_edge(v - 1, v);
  const std::vector<Index> degree = degrees_of(graph, 1);
  EXPECT_EQ(degree[0], 69);
  EXPECT_EQ(degree[199], 1);
  SearchBudget budget(1e9, 0);
  const std::vector<Word> left = drop_small_degrees(graph, degree, 69, 2, budget);
  for (Index v = 0; v < 200; ++v) EXPECT_EQ(test_bit(left.data(), v), v < 70) << v;
  const std::vector<Word> none = drop_small_degrees(graph, degree, 71, 1, budget);
  EXPECT_FALSE(any_bit(none.data(), static_cast<Index>(none.size())));
}

RC_GTEST_PROP(CoreFilter, NeverDropsAVertexOfALargerClique, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 140, 100);
  const CliqueResult best = max_clique(graph);
  const Index size = static_cast<Index>(best.vertices.size());
  SearchBudget budget(1e9, 0);
  const auto left = drop_small_degrees(graph, degrees_of(graph, 1), size - 1, 1, budget);
  for (const Index v : best.vertices) RC_ASSERT(test_bit(left.data(), v));
}

}  // namespace
}  // namespace gmcr::clique
