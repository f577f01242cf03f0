#include "kernels/bits/branch_choice.hpp"

#include <gtest/gtest.h>

#include <random>

#include "gmcr/clique.hpp"
#include "kernels/for_each_isa.hpp"

namespace gmcr {
namespace {

BitsetGraph random_graph(Index num_vertices, double density) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(num_vertices));
  BitsetGraph graph(num_vertices);
  for (Index u = 0; u < num_vertices; ++u) {
    for (Index v = 0; v < u; ++v) {
      if (static_cast<double>(generator() >> 11) < density * 0x1p53) graph.add_edge(u, v);
    }
  }
  return graph;
}

TEST(BranchChoice, PadsRowsToWholeVectors) {
  for (const auto& [bits, words] : std::vector<std::pair<Index, Index>>{
           {0, 4}, {1, 4}, {256, 4}, {257, 8}, {512, 8}, {513, 16}, {1024, 16}, {1025, 24}}) {
    EXPECT_EQ(kernels::padded_words(bits), words) << bits;
  }
}

// A search makes thousands of choices, in rows of each width that has loops of its own.
TEST(BranchChoice, LeadsToTheSameSearchOnEveryInstructionSet) {
  struct Case {
    Index num_vertices;
    double density;
  };
  for (const auto& [n, density] : {Case{120, 0.85}, {400, 0.5}, {700, 0.45}, {1300, 0.9}}) {
    const BitsetGraph graph = random_graph(n, density);
    CliqueOptions options;
    options.max_nodes = 3000;
    options.num_threads = 1;
    const CliqueResult best_set = max_clique(graph, options);
    EXPECT_GT(best_set.nodes, 100u);
    testing::for_each_isa([&] {
      const CliqueResult forced = max_clique(graph, options);
      EXPECT_EQ(forced.vertices, best_set.vertices);
      EXPECT_EQ(forced.upper_bound, best_set.upper_bound);
      EXPECT_EQ(forced.nodes, best_set.nodes);
    });
  }
}

TEST(BranchChoice, IntersectionIsCounted) {
  alignas(64) std::uint64_t a[8], b[8], both[8];
  std::mt19937_64 generator(1);
  for (int w = 0; w < 8; ++w) {
    a[w] = generator();
    b[w] = generator();
  }
  for (const Index words : {4, 8}) {
    testing::for_each_isa([&] {
      Index expected = 0;
      const Index count = kernels::intersect(a, b, words, both);
      for (Index w = 0; w < words; ++w) {
        EXPECT_EQ(both[w], a[w] & b[w]);
        expected += __builtin_popcountll(a[w] & b[w]);
      }
      EXPECT_EQ(count, expected);
    });
  }
}

}  // namespace
}  // namespace gmcr
