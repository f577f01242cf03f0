#include "clique/search/greedy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "clique/arbitrary.hpp"
#include "clique/graphs.hpp"

namespace gmcr::clique {
namespace {

bool is_maximal(const BitsetGraph& graph, const std::vector<Index>& clique) {
  for (Index v = 0; v < graph.num_vertices(); ++v) {
    bool fits = true;
    for (const Index u : clique) fits = fits && u != v && graph.has_edge(u, v);
    if (fits) return false;
  }
  return true;
}

RC_GTEST_PROP(GreedyClique, IsAMaximalCliqueWithItsStart, ()) {
  const BitsetGraph graph = test::arbitrary_graph(1, 149, 100);
  const Index n = graph.num_vertices();
  const Index start = test::uniform_in(0, n);
  const auto priority = *rc::gen::container<std::vector<Index>>(static_cast<std::size_t>(n),
                                                                rc::gen::inRange<Index>(0, 10));
  const Index max_candidates = test::uniform_in(0, 150);
  for (const auto& clique :
       {greedy_clique(graph, start, priority, 0), greedy_clique(graph, start, {}, 0),
        greedy_clique(graph, start, priority, max_candidates)}) {
    RC_ASSERT(test::is_ascending_clique(graph, clique));
    RC_ASSERT(is_maximal(graph, clique));
    RC_ASSERT(std::find(clique.begin(), clique.end(), start) != clique.end());
  }
}

TEST(GreedyClique, PrefersHighPriorityAndThenTheSmallestIndex) {
  // 0 is joined to 1, 2, 3, 4, which are not joined to each other.
  BitsetGraph star(5);
  for (Index v = 1; v < 5; ++v) star.add_edge(0, v);
  EXPECT_EQ(greedy_clique(star, 0, {}, 0), (std::vector<Index>{0, 1}));
  EXPECT_EQ(greedy_clique(star, 0, std::vector<Index>{0, 1, 7, 7, 3}, 0),
            (std::vector<Index>{0, 2}));
}

TEST(GreedyClique, CountsNeighboursAmongTheCandidates) {
  // The start 0 sees the triangle 4, 5, 6 and the vertex 1, which has the higher priority.
  BitsetGraph graph(7);
  for (const Index v : {1, 4, 5, 6}) graph.add_edge(0, v);
  graph.add_edge(4, 5);
  graph.add_edge(4, 6);
  graph.add_edge(5, 6);
  const std::vector<Index> priority{0, 9, 0, 0, 0, 0, 0};
  EXPECT_EQ(greedy_clique(graph, 0, priority, 0), (std::vector<Index>{0, 1}));
  EXPECT_EQ(greedy_clique(graph, 0, priority), (std::vector<Index>{0, 4, 5, 6}));
  EXPECT_EQ(greedy_clique(graph, 0, priority, 3), (std::vector<Index>{0, 1}));
}

TEST(GreedyClique, GoesByTheOrderOfThePrioritiesAndNotByTheirSize) {
  for (int seed = 0; seed < 10; ++seed) {
    const BitsetGraph graph = test::random_graph(200, 0.5, static_cast<std::uint64_t>(seed));
    std::vector<Index> narrow, wide;
    for (Index v = 0; v < 200; ++v) {
      narrow.push_back((v * 37 + seed) % 23 - 5);
      wide.push_back(1'000'000 * narrow.back());
    }
    for (const Index start : {0, 77, 199}) {
      EXPECT_EQ(greedy_clique(graph, start, narrow, 0), greedy_clique(graph, start, wide, 0));
      EXPECT_EQ(greedy_clique(graph, start, narrow, 40), greedy_clique(graph, start, wide, 40));
    }
  }
}

TEST(GreedyClique, RejectsAForeignStartAndAWrongNumberOfPriorities) {
  const BitsetGraph graph(3);
  EXPECT_THROW(greedy_clique(graph, 3, {}), std::invalid_argument);
  EXPECT_THROW(greedy_clique(graph, -1, {}), std::invalid_argument);
  EXPECT_THROW(greedy_clique(graph, 0, std::vector<Index>{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::clique
