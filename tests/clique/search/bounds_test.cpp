#include <gtest/gtest.h>

#include "clique/arbitrary.hpp"
#include "clique/graph/colouring.hpp"
#include "clique/graph/degeneracy.hpp"
#include "clique/graphs.hpp"
#include "clique/oracles.hpp"
#include "clique/search/branch_selector.hpp"

namespace gmcr::clique {
namespace {

std::vector<Word> all_vertices(const BitsetGraph& graph) {
  std::vector<Word> all(static_cast<std::size_t>(graph.words_per_row()), 0);
  for (Index v = 0; v < graph.num_vertices(); ++v) set_bit(all.data(), v);
  return all;
}

/// Neighbours of v among the vertices that are still there.
Index degree_among(const BitsetGraph& graph, Index v, const std::vector<char>& there) {
  Index degree = 0;
  for (Index u = 0; u < graph.num_vertices(); ++u) {
    degree += there[static_cast<std::size_t>(u)] && graph.has_edge(u, v);
  }
  return degree;
}

RC_GTEST_PROP(Degeneracy, TakesAVertexOfSmallestDegreeEachTime, ()) {
  const BitsetGraph graph = test::arbitrary_graph(0, 140, 100);
  const Degeneracy result = degeneracy_order(graph);
  const std::size_t n = static_cast<std::size_t>(graph.num_vertices());
  RC_ASSERT(result.order.size() == n);
  RC_ASSERT(result.core.size() == n);
  std::vector<char> there(n, 1);
  Index core = 0;
  for (const Index v : result.order) {
    RC_ASSERT(there[static_cast<std::size_t>(v)]);
    const Index degree = degree_among(graph, v, there);
    for (Index u = 0; u < graph.num_vertices(); ++u) {
      if (there[static_cast<std::size_t>(u)]) RC_ASSERT(degree <= degree_among(graph, u, there));
    }
    core = std::max(core, degree);
    RC_ASSERT(result.core[static_cast<std::size_t>(v)] == core);
    there[static_cast<std::size_t>(v)] = 0;
  }
  RC_ASSERT(result.degeneracy == core);
}

TEST(Degeneracy, OfACliqueWithATailIsThatOfTheClique) {
  BitsetGraph graph = test::disjoint_cliques(std::vector<Index>{5, 1, 1});
  graph.add_edge(4, 5);
  graph.add_edge(5, 6);
  const Degeneracy result = degeneracy_order(graph);
  EXPECT_EQ(result.degeneracy, 4);
  EXPECT_EQ(result.core, (std::vector<Index>{4, 4, 4, 4, 4, 1, 1}));
}

RC_GTEST_PROP(Colouring, IsProperAndBoundsTheCliqueNumber, ()) {
  const BitsetGraph graph = test::arbitrary_graph(0, 16, 100);
  const Index n = graph.num_vertices();
  std::vector<Index> seeds;
  if (n > 0) seeds = {test::uniform_in(0, n)};
  const Colouring colouring = colour_greedily(graph, all_vertices(graph), seeds);
  RC_ASSERT(static_cast<Index>(colouring.order.size()) == n);
  std::vector<Index> colour(colouring.order.size(), -1);
  for (std::size_t i = 0; i < colouring.order.size(); ++i) {
    colour[static_cast<std::size_t>(colouring.order[i])] = colouring.colour[i];
    if (i > 0) RC_ASSERT(colouring.colour[i - 1] <= colouring.colour[i]);
  }
  for (Index u = 0; u < n; ++u) {
    for (Index v = 0; v < n; ++v) {
      if (graph.has_edge(u, v)) {
        RC_ASSERT(colour[static_cast<std::size_t>(u)] != colour[static_cast<std::size_t>(v)]);
      }
    }
  }
  if (n > 0) RC_ASSERT(colour[static_cast<std::size_t>(seeds[0])] == 0);
  const Index clique_number = test::brute_force_clique_number(graph);
  RC_ASSERT(colouring.num_colours >= clique_number);
  RC_ASSERT(colour_greedily(graph, all_vertices(graph)).num_colours >= clique_number);
}

TEST(Colouring, OfASubsetIgnoresTheOtherVertices) {
  const BitsetGraph graph = test::complete_graph(70);
  std::vector<Word> subset(2, 0);
  for (const Index v : {3, 65, 69}) set_bit(subset.data(), v);
  EXPECT_EQ(colour_greedily(graph, subset).num_colours, 3);
  EXPECT_EQ(colour_greedily(graph, all_vertices(graph)).num_colours, 70);
  std::vector<Word> scratch;
  EXPECT_TRUE(colours_with(graph, subset, 3, scratch));
  EXPECT_FALSE(colours_with(graph, subset, 2, scratch));
}

RC_GTEST_PROP(BranchSelector, LeavesNoLargeCliqueOutsideItsBranches, ()) {
  const BitsetGraph graph = test::arbitrary_graph(0, 16, 100);
  const Index max_pruned = test::uniform_in(0, 12);
  BranchSelector selector;
  SearchBudget budget(1e9, 0);
  const PackedGraph packed = test::packed(graph);
  selector.reset(packed);
  kernels::AlignedWords all(packed.words_per_row(), 0);
  for (Index v = 0; v < graph.num_vertices(); ++v) set_bit(all.data(), v);
  std::vector<Branch> branches;
  const bool is_clique = selector.select(all.data(), max_pruned, budget, branches);
  const Index n = graph.num_vertices();
  RC_ASSERT(is_clique == (graph.num_edges() == n * (n - 1) / 2));

  // Without the branches, then with one after the other, the clique number keeps to the bound.
  std::vector<char> kept(static_cast<std::size_t>(n), 1);
  for (const Branch& branch : branches) kept[static_cast<std::size_t>(branch.vertex)] = 0;
  for (std::size_t i = 0; i <= branches.size(); ++i) {
    BitsetGraph induced(n);
    bool any = false;
    for (Index u = 0; u < n; ++u) {
      any = any || kept[static_cast<std::size_t>(u)];
      for (Index v = 0; v < u; ++v) {
        if (kept[static_cast<std::size_t>(u)] && kept[static_cast<std::size_t>(v)] &&
            graph.has_edge(u, v)) {
          induced.add_edge(u, v);
        }
      }
    }
    const Index bound = i == 0 ? max_pruned : branches[i - 1].bound;
    if (any) RC_ASSERT(test::brute_force_clique_number(induced) <= bound);
    if (i < branches.size()) kept[static_cast<std::size_t>(branches[i].vertex)] = 1;
  }
}

}  // namespace
}  // namespace gmcr::clique
