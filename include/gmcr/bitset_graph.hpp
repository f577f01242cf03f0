#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr {

/// Undirected simple graph, one bit a vertex pair: row v holds the neighbours of v.
///
/// Invariants: symmetric, no loops, bits past the last vertex are 0.
/// Memory: `bytes_required(n)`, about n^2 / 8.
class BitsetGraph {
 public:
  using Word = std::uint64_t;
  static constexpr Index kBitsPerWord = 64;

  /// Graph without edges.
  /// @throws std::invalid_argument where `num_vertices` < 0.
  explicit BitsetGraph(Index num_vertices = 0);

  /// Bytes that the adjacency of a graph with `num_vertices` vertices takes.
  static std::size_t bytes_required(Index num_vertices);

  Index num_vertices() const { return num_vertices_; }
  Index words_per_row() const { return words_per_row_; }
  Index num_edges() const;
  Index degree(Index v) const;
  bool has_edge(Index u, Index v) const {
    return (row(u)[static_cast<std::size_t>(v / kBitsPerWord)] >> (v % kBitsPerWord)) & 1u;
  }

  /// Adds the edge {u, v}.
  /// @throws std::invalid_argument where u == v or a vertex is out of range.
  void add_edge(Index u, Index v);

  std::span<const Word> row(Index v) const {
    return {words_.data() + v * words_per_row_, static_cast<std::size_t>(words_per_row_)};
  }

  /// Raw row for builders that write all rows themselves; they keep the invariants.
  std::span<Word> mutable_row(Index v) {
    return {words_.data() + v * words_per_row_, static_cast<std::size_t>(words_per_row_)};
  }

 private:
  Index num_vertices_ = 0;
  Index words_per_row_ = 0;
  std::vector<Word> words_;
};

}  // namespace gmcr
