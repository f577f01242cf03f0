#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/weighted/branch_and_bound.hpp"
#include "clique/weights.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What any result for whole weights promises, whatever ended it; their sums do not round.
void expect_valid(const BitsetGraph& graph, const WeightedCliqueResult& result, double heaviest,
                  double must_exceed = 0) {
  EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
  EXPECT_GE(result.upper_bound, result.weight);
  EXPECT_GE(std::max(result.upper_bound, must_exceed), heaviest);
  EXPECT_EQ(result.proven_optimal, result.upper_bound <= std::max(result.weight, must_exceed));
}

TEST(WeightedCliqueLimits, EveryNodeBudgetLeavesAValidBound) {
  std::uint64_t seed = 0;
  for (const double density : {0.5, 0.8, 0.95}) {
    const BitsetGraph graph = test::random_graph(80, density, ++seed);
    const std::vector<int> whole = test::whole_weights(80, 12, seed);
    const std::vector<double> weights(whole.begin(), whole.end());
    const auto heaviest = static_cast<double>(test::cliquer_clique_weight(graph, whole));
    const WeightedCliqueResult full = max_weight_clique(graph, weights);
    EXPECT_EQ(full.weight, heaviest);
    bool ended_early = false;
    WeightedCliqueOptions options;
    for (std::uint64_t nodes = 0; nodes < full.nodes + 2; nodes += 1 + nodes / 8) {
      options.max_nodes = nodes;
      const WeightedCliqueResult result = max_weight_clique(graph, weights, options);
      expect_valid(graph, result, heaviest);
      EXPECT_LE(result.nodes, nodes);
      ended_early = ended_early || !result.proven_optimal;
    }
    EXPECT_TRUE(ended_early) << "the budget must have been able to bind at density " << density;
  }
}

TEST(WeightedCliqueLimits, WorkAndMemoryThatDoNotSufficeLeaveAValidBound) {
  const BitsetGraph graph = test::random_graph(300, 0.6, 4);
  const std::vector<int> whole = test::whole_weights(300, 12, 4);
  const std::vector<double> weights(whole.begin(), whole.end());
  const double heaviest = max_weight_clique(graph, weights).weight;
  WeightedCliqueOptions no_memory;
  no_memory.max_memory = 1000;
  const WeightedCliqueResult bounded = max_weight_clique(graph, weights, no_memory);
  expect_valid(graph, bounded, heaviest);
  EXPECT_FALSE(bounded.proven_optimal);
  EXPECT_EQ(bounded.nodes, 0u);
  bool ended_early = false;
  for (std::uint64_t work = 0; work < (1 << 22); work += 1 << 18) {
    WeightedCliqueOptions options;
    options.max_work = work;
    const WeightedCliqueResult result = max_weight_clique(graph, weights, options);
    expect_valid(graph, result, heaviest);
    ended_early = ended_early || !result.proven_optimal;
  }
  EXPECT_TRUE(ended_early) << "the work must have been able to bind";
}

TEST(WeightedCliqueLimits, EveryNodeBudgetOfTheInnerSearchLeavesAValidBound) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const BitsetGraph graph = test::random_graph(16, 0.3 + 0.015 * static_cast<double>(seed), seed);
    const std::vector<int> whole = test::whole_weights(16, 7, seed);
    const std::vector<std::int64_t> units(whole.begin(), whole.end());
    const std::vector<double> weights(whole.begin(), whole.end());
    const auto heaviest =
        static_cast<std::int64_t>(test::brute_force_clique_weight(graph, weights));
    WeightedBranchAndBound search;
    for (std::uint64_t max_nodes = 0; max_nodes < 30; ++max_nodes) {
      for (const std::int64_t to_beat : {0, 12, 24}) {
        SearchBudget budget(1e9, max_nodes);
        const auto outcome = search.search(graph, units, to_beat, WeightRounding(), budget);
        EXPECT_GE(outcome.upper_bound, std::max(heaviest, to_beat));
        if (!budget.spent()) {
          EXPECT_EQ(outcome.upper_bound, std::max(heaviest, to_beat));
          EXPECT_EQ(outcome.clique.empty(), heaviest <= to_beat);
        }
      }
    }
  }
}

TEST(WeightedCliqueLimits, NodeBudgetIsDeterministic) {
  const BitsetGraph graph = test::random_graph(200, 0.8, 4);
  const std::vector<double> weights = test::cluster_weights(200, 4);
  WeightedCliqueOptions options;
  options.max_nodes = 500;
  const WeightedCliqueResult first = max_weight_clique(graph, weights, options);
  const WeightedCliqueResult second = max_weight_clique(graph, weights, options);
  EXPECT_FALSE(first.proven_optimal);
  EXPECT_EQ(first.nodes, 500u);
  EXPECT_EQ(first.vertices, second.vertices);
  EXPECT_EQ(first.upper_bound, second.upper_bound);
}

TEST(WeightedCliqueLimits, NoTimeReturnsAtOnceWithAValidBound) {
  const BitsetGraph graph = test::random_graph(400, 0.9, 5);
  WeightedCliqueOptions options;
  options.time_limit = 0;
  const auto result = max_weight_clique(graph, std::vector<double>(400, 0.5), options);
  EXPECT_FALSE(result.proven_optimal);
  EXPECT_EQ(result.upper_bound, 200);
  EXPECT_EQ(result.nodes, 0u);
}

TEST(WeightedCliqueLimits, TimeLimitEndsAHardSearch) {
  const BitsetGraph graph = test::random_graph(600, 0.95, 6);
  WeightedCliqueOptions options;
  options.time_limit = 0.2;
  const auto start = std::chrono::steady_clock::now();
  const auto result = max_weight_clique(graph, test::cluster_weights(600, 6), options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_FALSE(result.proven_optimal);
  EXPECT_GT(result.upper_bound, result.weight);
  EXPECT_LT(elapsed.count(), 5.0);
}

TEST(WeightedCliqueLimits, ALargeDenseGraphEndsByItsNodesWithAUsefulBound) {
  const BitsetGraph graph = test::random_graph(1000, 0.9, 7);
  for (const std::vector<double>& weights :
       {std::vector<double>(1000, 1.0), test::cluster_weights(1000, 8)}) {
    WeightedCliqueOptions options;
    options.max_nodes = 50;
    const WeightedCliqueResult result = max_weight_clique(graph, weights, options);
    EXPECT_TRUE(test::is_ascending_clique(graph, result.vertices));
    EXPECT_FALSE(result.proven_optimal);
    EXPECT_GT(result.weight, 45);
    EXPECT_GT(result.upper_bound, result.weight);
    EXPECT_LT(result.upper_bound, 350);
  }
}

TEST(WeightedCliqueLimits, ALargeCliqueFitsTheStackAndTheTime) {
  const std::vector<double> weights = test::cluster_weights(3000, 10);
  BitsetGraph graph = test::complete_multipartite_graph(3000, 2999);
  const WeightedCliqueResult result = max_weight_clique(graph, weights);
  EXPECT_TRUE(result.proven_optimal);
  EXPECT_EQ(result.vertices.size(), 2999u);
}

TEST(WeightedCliqueLimits, MustExceedProvesThatNoHeavierCliqueExists) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const BitsetGraph graph = test::random_graph(14, 0.1 + 0.014 * static_cast<double>(seed), seed);
    const std::vector<int> whole = test::whole_weights(14, 4, seed);
    const std::vector<double> weights(whole.begin(), whole.end());
    const double heaviest = test::brute_force_clique_weight(graph, weights);
    for (double floor = 0; floor <= 40; floor += 0.5) {
      WeightedCliqueOptions options;
      options.must_exceed = floor;
      const WeightedCliqueResult result = max_weight_clique(graph, weights, options);
      expect_valid(graph, result, heaviest, floor);
      EXPECT_TRUE(result.proven_optimal);
      if (heaviest > floor) {
        EXPECT_EQ(result.weight, heaviest);
      } else {
        EXPECT_LE(result.upper_bound, floor);
      }
    }
  }
}

TEST(WeightedCliqueLimits, MustExceedSavesNodes) {
  const BitsetGraph graph = test::random_graph(150, 0.7, 12);
  const std::vector<double> weights = test::cluster_weights(150, 12);
  const WeightedCliqueResult free = max_weight_clique(graph, weights);
  WeightedCliqueOptions options;
  options.must_exceed = free.upper_bound + 2;
  EXPECT_LT(max_weight_clique(graph, weights, options).nodes, free.nodes);
}

TEST(WeightedCliqueLimits, AWeightThatRoundingAloneSeparatesIsNotExceeded) {
  // Ten tenths add up to just less than 1 in double.
  std::vector<double> weights(10, 0.1);
  for (const bool equal : {true, false}) {
    if (!equal) weights[3] = weights[4] = 0.05;
    const double sum = equal ? 1.0 : 0.9;
    WeightedCliqueOptions options;
    options.must_exceed = sum * (1 - 4e-16);
    const BitsetGraph graph = test::complete_graph(10);
    const WeightedCliqueResult result = max_weight_clique(graph, weights, options);
    EXPECT_TRUE(result.proven_optimal);
    EXPECT_LE(result.weight, options.must_exceed);
    EXPECT_LE(result.upper_bound, sum * (1 + 1e-11));
    options.must_exceed = sum * (1 - 1e-9);
    EXPECT_EQ(max_weight_clique(graph, weights, options).vertices.size(), 10u);
  }
}

TEST(WeightedCliqueLimits, AnythingExceedsNothingAndNothingExceedsInfinity) {
  const BitsetGraph graph = test::complete_graph(5);
  const std::vector<double> weights(5, 1.0);
  WeightedCliqueOptions options;
  options.must_exceed = kInfinity;
  EXPECT_TRUE(max_weight_clique(graph, weights, options).proven_optimal);
  options.must_exceed = 1e308;
  EXPECT_LE(max_weight_clique(graph, weights, options).upper_bound, 5);
  options.must_exceed = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(max_weight_clique(graph, weights, options).weight, 5);
}

std::string message_of(const std::vector<double>& weights,
                       const WeightedCliqueOptions& options = {}) {
  try {
    max_weight_clique(BitsetGraph(2), weights, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(WeightedCliqueLimits, OptionsOutOfRangeAreRejectedByName) {
  WeightedCliqueOptions options;
  for (const double wrong : {-1.0, std::nan("")}) {
    options = {};
    options.time_limit = wrong;
    EXPECT_EQ(message_of({1, 1}, options).find("time_limit: "), 0u);
    options = {};
    options.must_exceed = wrong;
    EXPECT_EQ(message_of({1, 1}, options).find("must_exceed: "), 0u);
  }
}

TEST(WeightedCliqueLimits, WeightsThatDoNotFitAreRejectedByVertex) {
  EXPECT_EQ(message_of({1}).find("weights: 1 values for 2 vertices"), 0u);
  for (const double wrong : {-1.0, std::nan(""), kInfinity, -kInfinity}) {
    EXPECT_NE(message_of({1, wrong}).find("vertex 1"), std::string::npos) << wrong;
  }
  EXPECT_EQ(message_of({1e308, 1e308}).find("weights: their sum"), 0u);
}

}  // namespace
}  // namespace gmcr::clique
