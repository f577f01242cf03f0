#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "clique/arbitrary.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/weighted/colouring.hpp"
#include "clique/weighted/fixed_point_weights.hpp"
#include "clique/weighted/greedy.hpp"
#include "clique/weighted/peeling.hpp"
#include "clique/weights.hpp"

namespace gmcr::clique {
namespace {

std::vector<Word> all_vertices(const BitsetGraph& graph) {
  std::vector<Word> all(static_cast<std::size_t>(graph.words_per_row()), 0);
  for (Index v = 0; v < graph.num_vertices(); ++v) set_bit(all.data(), v);
  return all;
}

std::vector<std::int64_t> whole_units(Index num_vertices, std::uint64_t seed) {
  const std::vector<int> whole = test::whole_weights(num_vertices, 9, seed);
  return {whole.begin(), whole.end()};
}

/// Weight of the heaviest clique among `vertices`, for at most 20 vertices.
std::int64_t heaviest_among(const BitsetGraph& graph, std::vector<std::int64_t> units,
                            const std::vector<Word>& vertices) {
  std::vector<double> weights;
  for (Index v = 0; v < graph.num_vertices(); ++v) {
    const bool is_in = test_bit(vertices.data(), v);
    weights.push_back(is_in ? static_cast<double>(units[static_cast<std::size_t>(v)]) : 0.0);
  }
  return static_cast<std::int64_t>(test::brute_force_clique_weight(graph, weights));
}

SearchBudget unlimited() {
  return {std::numeric_limits<double>::infinity(), std::numeric_limits<std::uint64_t>::max()};
}

TEST(FixedPointWeights, AddUpToAtLeastTheWeights) {
  const std::vector<double> weights{1.0 / 3, 1e-17, 0.1, 0, 1e-300, 7};
  const FixedPointWeights fixed(weights);
  EXPECT_GE(fixed.weight_of(fixed.total()), std::accumulate(weights.begin(), weights.end(), 0.0));
  EXPECT_LE(fixed.weight_of(fixed.total()), 7.4333333333333336 * (1 + 1e-15));
  EXPECT_EQ(fixed.units()[3], 0);
  EXPECT_EQ(fixed.units()[4], 1);
  EXPECT_LT(fixed.total(), std::int64_t{1} << 62);
}

TEST(FixedPointWeights, CountWhatUnderflowsAsAUnit) {
  const FixedPointWeights fixed(std::vector<double>{1e300, 1e-300, 0});
  EXPECT_EQ(fixed.units()[1], 1);
  EXPECT_EQ(fixed.units()[2], 0);
}

TEST(FixedPointWeights, ConvertUnitsThatAreDoublesExactly) {
  const FixedPointWeights fixed(std::vector<double>{1, 0.5, 3});
  EXPECT_EQ(fixed.weight_of(fixed.total()), 4.5);
  EXPECT_EQ(fixed.units_of(0.5), fixed.units()[1]);
  EXPECT_EQ(fixed.units_of(1e308), std::int64_t{1} << 62);
}

TEST(FixedPointWeights, CallOnlySumsThatRoundEqualWhenTheyDiffer) {
  const std::int64_t units = std::int64_t{1} << 60;
  const FixedPointWeights whole(std::vector<double>{1, 0.5, 3}), thirds({{1.0 / 3, 1.0}});
  EXPECT_EQ(whole.rounding().to_beat(units), units);
  EXPECT_GT(thirds.rounding().to_beat(units), units);
  EXPECT_LE(thirds.rounding().to_beat(units), units + units / 1'000'000'000'000);
}

RC_GTEST_PROP(WeightedPeeling, LosesNoVertexOfAHeavierClique, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 14, 100);
  const auto units = whole_units(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const std::int64_t to_beat = test::uniform_in(0, 60);
  SearchBudget budget = unlimited();
  WeightedPeeling peeling;
  peeling.reset(graph, units, *rc::gen::element(std::int64_t{0}, to_beat), budget);
  peeling.peel(to_beat);
  const std::int64_t before = heaviest_among(graph, units, all_vertices(graph));
  const std::int64_t after = heaviest_among(graph, units, peeling.alive());
  RC_ASSERT(after == before || before <= to_beat);
  RC_ASSERT(peeling.heaviest_neighborhood() >= after);
}

RC_GTEST_PROP(WeightedPeeling, LeavesOnlyNeighbourhoodsThatAreHeavyEnough, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 140, 60);
  const auto units = whole_units(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const std::int64_t to_beat = test::uniform_in(0, 400);
  SearchBudget budget = unlimited();
  WeightedPeeling peeling;
  peeling.reset(graph, units, *rc::gen::element(std::int64_t{0}, to_beat), budget);
  peeling.peel(to_beat);
  Index num_alive = 0;
  for (Index v = 0; v < graph.num_vertices(); ++v) {
    if (!test_bit(peeling.alive().data(), v)) continue;
    ++num_alive;
    std::int64_t sum = units[static_cast<std::size_t>(v)];
    for (Index u = 0; u < graph.num_vertices(); ++u) {
      const bool counts = test_bit(peeling.alive().data(), u) && graph.has_edge(u, v);
      if (counts) sum += units[static_cast<std::size_t>(u)];
    }
    RC_ASSERT(sum > to_beat);
    RC_ASSERT(sum == peeling.neighborhoods()[v]);
  }
  RC_ASSERT(num_alive == peeling.num_alive());
}

TEST(WeightedPeeling, UnravelsAPathFromItsEnds) {
  BitsetGraph path(200);
  for (Index v = 1; v < 200; ++v) path.add_edge(v - 1, v);
  const std::vector<std::int64_t> units(200, 1);
  SearchBudget budget = unlimited();
  WeightedPeeling peeling;
  peeling.reset(path, units, 0, budget);
  EXPECT_EQ(peeling.heaviest_neighborhood(), 3);
  peeling.peel(2);
  EXPECT_EQ(peeling.num_alive(), 0);
  EXPECT_EQ(peeling.heaviest_neighborhood(), 0);
}

RC_GTEST_PROP(WeightedColoring, BoundsTheCliquesOfTheBranchesUpToEach, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 14, 100);
  const auto units = whole_units(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const std::int64_t max_pruned = test::uniform_in(0, 40);
  const auto splitting = *rc::gen::element(Splitting::None, Splitting::Full);
  SearchBudget budget = unlimited();
  WeightedColoring coloring;
  coloring.reset(graph, units, budget);
  std::vector<WeightedBranch> branches;
  std::vector<Word> here = all_vertices(graph);
  coloring.select(here.data(), max_pruned, splitting, branches);
  for (; !branches.empty(); branches.pop_back()) {
    RC_ASSERT(branches.back().bound > max_pruned);
    RC_ASSERT(branches.back().bound >= heaviest_among(graph, units, here));
    clear_bit(here.data(), branches.back().vertex);
  }
  RC_ASSERT(heaviest_among(graph, units, here) <= max_pruned);
}

RC_GTEST_PROP(WeightedColoring, ThatCoversProvesThatNoCliqueIsHeavier, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 14, 100);
  const auto units = whole_units(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  SearchBudget budget = unlimited();
  WeightedColoring coloring;
  coloring.reset(graph, units, budget);
  const std::vector<Word> all = all_vertices(graph);
  const std::int64_t heaviest = heaviest_among(graph, units, all);
  RC_ASSERT(!coloring.covers(all.data(), heaviest - 1));
  RC_ASSERT(coloring.covers(all.data(), std::accumulate(units.begin(), units.end(), 0)));
}

TEST(WeightedColoring, ChargesAClassItsHeaviestVertex) {
  BitsetGraph star(4);
  for (const Index leaf : {1, 2, 3}) star.add_edge(0, leaf);
  // Leaves of 1, 2, 3 share a class that costs 3; the centre costs 2 more.
  const std::vector<std::int64_t> units{2, 1, 2, 3};
  SearchBudget budget = unlimited();
  WeightedColoring coloring;
  coloring.reset(star, units, budget);
  EXPECT_TRUE(coloring.covers(all_vertices(star).data(), 5));
  EXPECT_FALSE(coloring.covers(all_vertices(star).data(), 4));
  EXPECT_EQ(coloring.bound(all_vertices(star).data()), 5);
}

TEST(WeightedColoring, IsTighterWithSplitting) {
  int tighter = 0, looser = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const BitsetGraph graph = test::random_graph(60, 0.7, seed);
    const auto units = whole_units(60, seed);
    SearchBudget budget = unlimited();
    WeightedColoring coloring;
    coloring.reset(graph, units, budget);
    std::vector<WeightedBranch> plain, split;
    coloring.select(all_vertices(graph).data(), 0, Splitting::None, plain);
    coloring.select(all_vertices(graph).data(), 0, Splitting::Full, split);
    tighter += split.back().bound < plain.back().bound;
    looser += split.back().bound > plain.back().bound;
  }
  EXPECT_GE(tighter, 45);
  EXPECT_LE(looser, 5);
}

TEST(WeightedColoring, RecognisesACliqueAndNothingElse) {
  const std::vector<std::int64_t> units = whole_units(70, 1);
  SearchBudget budget = unlimited();
  WeightedColoring coloring;
  std::vector<WeightedBranch> branches;
  BitsetGraph graph = test::complete_graph(70);
  coloring.reset(graph, units, budget);
  EXPECT_TRUE(coloring.select(all_vertices(graph).data(), 0, Splitting::Full, branches));
  graph = test::complete_multipartite_graph(70, 69);
  coloring.reset(graph, units, budget);
  EXPECT_FALSE(coloring.select(all_vertices(graph).data(), 0, Splitting::Full, branches));
}

TEST(WeightedBounds, WorkBeyondTheBudgetLeavesValidBoundsInEveryPart) {
  const BitsetGraph graph = test::random_graph(90, 0.8, 17);
  const std::vector<int> whole = test::whole_weights(90, 9, 17);
  const std::vector<std::int64_t> units(whole.begin(), whole.end());
  const Index heaviest = test::cliquer_clique_weight(graph, whole);
  SearchBudget spent(0, 0);
  spent.out_of_time();
  WeightedPeeling peeling;
  peeling.reset(graph, units, 0, spent);
  EXPECT_GE(peeling.heaviest_neighborhood(), heaviest);
  peeling.peel(heaviest - 1);
  EXPECT_GE(peeling.heaviest_neighborhood(), heaviest);
  WeightedColoring coloring;
  coloring.reset(graph, units, spent);
  std::vector<WeightedBranch> branches;
  EXPECT_FALSE(coloring.select(all_vertices(graph).data(), 20, Splitting::Full, branches));
  EXPECT_GE(branches.back().bound, heaviest);
  EXPECT_FALSE(coloring.covers(all_vertices(graph).data(), 1000));
  EXPECT_GE(coloring.bound(all_vertices(graph).data()), heaviest);
  EXPECT_EQ(greedy_heavy_clique(graph, units, 0, graph.row(0), units, spent),
            std::vector<Index>{0});
}

RC_GTEST_PROP(GreedyHeavyClique, IsAMaximalCliqueAmongTheCandidates, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 140, 90);
  const auto units = whole_units(graph.num_vertices(), *rc::gen::arbitrary<std::uint64_t>());
  const Index start = test::uniform_in(0, graph.num_vertices());
  std::vector<Word> candidates(graph.row(start).begin(), graph.row(start).end());
  for (Index v = 0; v < graph.num_vertices(); v += 3) clear_bit(candidates.data(), v);
  SearchBudget budget = unlimited();
  std::vector<Index> clique = greedy_heavy_clique(graph, units, start, candidates, units, budget);
  RC_ASSERT(clique.front() == start);
  std::sort(clique.begin(), clique.end());
  RC_ASSERT(test::is_ascending_clique(graph, clique));
  for_each_bit(candidates.data(), graph.words_per_row(), [&](Index v) {
    const bool fits = std::all_of(clique.begin(), clique.end(),
                                  [&](Index u) { return u != v && graph.has_edge(u, v); });
    RC_ASSERT(!fits);
  });
  for (const Index v : clique) RC_ASSERT(v == start || test_bit(candidates.data(), v));
}

TEST(GreedyHeavyClique, PrefersTheHeavyNeighbourhood) {
  // Vertex 0 with a triangle of weight 2 each and a clique of five of weight 1 each.
  BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{1, 3, 5});
  for (Index v = 1; v < 9; ++v) graph.add_edge(0, v);
  const std::vector<std::int64_t> units{1, 2, 2, 2, 1, 1, 1, 1, 1};
  SearchBudget budget = unlimited();
  EXPECT_EQ(greedy_heavy_clique(graph, units, 0, graph.row(0), units, budget),
            (std::vector<Index>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace gmcr::clique
