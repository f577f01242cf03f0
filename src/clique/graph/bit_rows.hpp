#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/types.hpp"

namespace gmcr::clique {

using Word = BitsetGraph::Word;
inline constexpr Index kBitsPerWord = BitsetGraph::kBitsPerWord;

/// Words that hold `num_bits` bits.
inline Index words_for_bits(Index num_bits) { return (num_bits + kBitsPerWord - 1) / kBitsPerWord; }

inline bool test_bit(const Word* bits, Index i) {
  return (bits[i / kBitsPerWord] >> (i % kBitsPerWord)) & 1u;
}
inline void set_bit(Word* bits, Index i) {
  bits[i / kBitsPerWord] |= Word{1} << (i % kBitsPerWord);
}
inline void clear_bit(Word* bits, Index i) {
  bits[i / kBitsPerWord] &= ~(Word{1} << (i % kBitsPerWord));
}

/// Set bits among `num_words` words w(0), w(1), ...
///
/// Adds within bytes, so that the compiler can vectorise the loop on machines without a popcount
/// instruction in their baseline (x86-64).
template <typename WordAt>
Index count_bits_of(Index num_words, WordAt word_at) {
  constexpr Word kPairs = 0x5555555555555555, kQuads = 0x3333333333333333;
  constexpr Word kNibbles = 0x0f0f0f0f0f0f0f0f, kBytes = 0x00ff00ff00ff00ff;
  constexpr Index kBlock = 31;  // 31 words add at most 8 * 31 < 256 to a byte
  Index count = 0;
  for (Index begin = 0; begin < num_words; begin += kBlock) {
    const Index end = std::min(num_words, begin + kBlock);
    Word bytes = 0;
    for (Index i = begin; i < end; ++i) {
      Word x = word_at(i);
      x -= (x >> 1) & kPairs;
      x = (x & kQuads) + ((x >> 2) & kQuads);
      bytes += (x + (x >> 4)) & kNibbles;
    }
    bytes = (bytes & kBytes) + ((bytes >> 8) & kBytes);
    count += static_cast<Index>((bytes * 0x0001000100010001) >> 48);
  }
  return count;
}

inline Index count_bits(const Word* bits, Index num_words) {
  return count_bits_of(num_words, [=](Index i) { return bits[i]; });
}

inline bool any_bit(const Word* bits, Index num_words) {
  for (Index i = 0; i < num_words; ++i) {
    if (bits[i] != 0) return true;
  }
  return false;
}

/// Calls visit(i) for every set bit i, ascending. The bits may change behind i only.
template <typename Visit>
void for_each_bit(const Word* bits, Index num_words, Visit visit) {
  for (Index i = 0; i < num_words; ++i) {
    for (Word rest = bits[i]; rest != 0; rest &= rest - 1) {
      visit(i * kBitsPerWord + std::countr_zero(rest));
    }
  }
}

/// The adjacency rows of a graph, wherever they are stored.
struct RowsView {
  const Word* words = nullptr;
  Index num_vertices = 0;
  Index words_per_row = 0;

  RowsView() = default;
  RowsView(const Word* data, Index vertices, Index stride)
      : words(data), num_vertices(vertices), words_per_row(stride) {}
  RowsView(const BitsetGraph& graph)  // NOLINT(google-explicit-constructor): a view of the graph
      : num_vertices(graph.num_vertices()), words_per_row(graph.words_per_row()) {
    if (num_vertices > 0) words = graph.row(0).data();
  }

  const Word* row(Index v) const { return words + v * words_per_row; }
  Index degree(Index v) const { return count_bits(row(v), words_per_row); }
};

}  // namespace gmcr::clique
