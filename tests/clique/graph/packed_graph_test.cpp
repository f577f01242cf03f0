#include "clique/graph/packed_graph.hpp"

#include <gtest/gtest.h>

#include "clique/clique.hpp"
#include "clique/graphs.hpp"

namespace gmcr::clique {
namespace {

// Few and many vertices of a wide graph take different routes.
TEST(PackedGraph, IsTheInducedSubgraphInTheOrderGiven) {
  const BitsetGraph graph = test::random_graph(700, 0.3, 1);
  PackedGraph packed;
  for (const std::size_t count : {650u, 5u, 0u, 10u, 11u, 64u, 65u, 700u}) {
    std::vector<Index> vertices = test::random_permutation(700, count);
    vertices.resize(count);
    packed.assign(graph, vertices);
    ASSERT_EQ(packed.num_vertices(), static_cast<Index>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const Index u = static_cast<Index>(i);
      EXPECT_EQ(packed.original(u), vertices[i]);
      Index degree = 0;
      for (std::size_t j = 0; j < count; ++j) {
        const bool expected = i != j && graph.has_edge(vertices[i], vertices[j]);
        ASSERT_EQ(test_bit(packed.row(u), static_cast<Index>(j)), expected);
        degree += expected;
      }
      EXPECT_EQ(packed.view().degree(u), degree) << "bits behind the last vertex are clear";
    }
  }
}

// Rows of packed graphs are padded: one word or many must both arrive, and nothing behind them.
TEST(InducedSubgraph, HasTheEdgesAmongItsVertices) {
  const BitsetGraph graph = test::random_graph(300, 0.4, 2);
  for (const std::size_t count : {0u, 1u, 20u, 64u, 65u, 130u, 300u}) {
    std::vector<Index> vertices = test::random_permutation(300, count);
    vertices.resize(count);
    const BitsetGraph subgraph = induced_subgraph(graph, vertices);
    ASSERT_EQ(subgraph.num_vertices(), static_cast<Index>(count));
    Index num_edges = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool expected = graph.has_edge(vertices[i], vertices[j]);
        ASSERT_EQ(subgraph.has_edge(static_cast<Index>(i), static_cast<Index>(j)), expected);
        num_edges += expected;
      }
    }
    EXPECT_EQ(subgraph.num_edges(), num_edges);
  }
}

}  // namespace
}  // namespace gmcr::clique
