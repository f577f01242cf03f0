#include "gmcr/bitset_graph.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "clique/graph/bit_rows.hpp"
#include "clique/graphs.hpp"

namespace gmcr::clique {
namespace {

TEST(BitsetGraph, EdgesAreSymmetricAndCountedOnce) {
  BitsetGraph graph(130);
  graph.add_edge(0, 129);
  graph.add_edge(129, 64);
  graph.add_edge(129, 0);
  EXPECT_TRUE(graph.has_edge(0, 129));
  EXPECT_TRUE(graph.has_edge(129, 0));
  EXPECT_TRUE(graph.has_edge(64, 129));
  EXPECT_FALSE(graph.has_edge(0, 64));
  EXPECT_EQ(graph.num_edges(), 2);
  EXPECT_EQ(graph.degree(129), 2);
  EXPECT_EQ(graph.degree(1), 0);
}

TEST(BitsetGraph, RowsHoldWholeWords) {
  for (const Index n : {0, 1, 63, 64, 65, 511, 512, 513}) {
    const BitsetGraph graph(n);
    EXPECT_EQ(graph.words_per_row(), (n + 63) / 64) << n;
    EXPECT_EQ(BitsetGraph::bytes_required(n), static_cast<std::size_t>(n * ((n + 63) / 64) * 8));
  }
}

TEST(BitsetGraph, RejectsLoopsForeignVerticesAndNegativeSizes) {
  BitsetGraph graph(3);
  EXPECT_THROW(graph.add_edge(1, 1), std::invalid_argument);
  EXPECT_THROW(graph.add_edge(0, 3), std::invalid_argument);
  EXPECT_THROW(graph.add_edge(-1, 0), std::invalid_argument);
  EXPECT_THROW(BitsetGraph(-1), std::invalid_argument);
  EXPECT_EQ(graph.num_edges(), 0);
}

TEST(BitRows, CountOfBitsIsThatOfPopcountForAnyLength) {
  std::mt19937_64 generator(5);
  for (const std::size_t length : {0u, 1u, 2u, 30u, 31u, 32u, 62u, 63u, 200u}) {
    std::vector<Word> words(length);
    Index expected = 0;
    for (Word& word : words) {
      word = generator();
      expected += std::popcount(word);
    }
    EXPECT_EQ(count_bits(words.data(), static_cast<Index>(length)), expected);
    std::fill(words.begin(), words.end(), ~Word{0});
    EXPECT_EQ(count_bits(words.data(), static_cast<Index>(length)),
              static_cast<Index>(64 * length));
  }
}

}  // namespace
}  // namespace gmcr::clique
