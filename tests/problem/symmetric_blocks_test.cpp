#include "problem/graph/symmetric_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gmcr::problem {
namespace {

BitsetGraph random_graph(std::uint64_t seed, Index count) {
  std::mt19937_64 generator(seed);
  BitsetGraph graph(count);
  for (Index v = 0; v < count; ++v) {
    for (Index u = 0; u < v; ++u) {
      if (generator() % 3 == 0) graph.add_edge(u, v);
    }
  }
  return graph;
}

void expect_equal(const BitsetGraph& a, const BitsetGraph& b) {
  for (Index v = 0; v < a.num_vertices(); ++v) {
    const auto x = a.row(v), y = b.row(v);
    ASSERT_TRUE(std::equal(x.begin(), x.end(), y.begin())) << a.num_vertices() << ' ' << v;
  }
}

TEST(Mirror, WritesTheWordsLeftOfTheDiagonal) {
  for (const Index count : {0, 1, 63, 64, 65, 511, 512, 513, 1100}) {
    const BitsetGraph whole = random_graph(static_cast<std::uint64_t>(count), count);
    for (const int threads : {1, 3}) {
      BitsetGraph graph = whole;
      for (Index v = 0; v < count; ++v) {
        // what is there before is overwritten
        for (std::size_t w = 0; w < static_cast<std::size_t>(v / 64); ++w) {
          graph.mutable_row(v)[w] = 0x123456789;
        }
      }
      mirror_upper_blocks(graph, threads);
      expect_equal(graph, whole);
    }
  }
}

TEST(Mirror, OfBlocksIsTheGraphThatTheyAreOf) {
  for (const Index count : {0, 1, 63, 64, 65, 511, 512, 513, 1100}) {
    const BitsetGraph whole = random_graph(static_cast<std::uint64_t>(count) + 1, count);
    for (const int threads : {1, 3}) {
      BitsetGraph graph(count);
      write_symmetric_blocks(
          graph, threads, parallel::Deadline::never(), [&](Index row_block, Index column_block) {
            EXPECT_LE(row_block, column_block);
            kernels::BitBlock bits{};
            for (Index r = 0; r < 64 && 64 * row_block + r < count; ++r) {
              bits[static_cast<std::size_t>(r)] =
                  whole.row(64 * row_block + r)[static_cast<std::size_t>(column_block)];
            }
            return bits;
          });
      expect_equal(graph, whole);
    }
  }
}

}  // namespace
}  // namespace gmcr::problem
