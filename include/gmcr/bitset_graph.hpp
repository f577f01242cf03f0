#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {
namespace detail {

/// Memory that reads as 0 and that the threads which first write to it bring in, in large pages
/// where the system grants them.
/// @throws std::bad_alloc
void* allocate_zeroed(std::size_t bytes);
void free_zeroed(void* memory) noexcept;

/// Allocator of vectors whose new elements are 0 without being written.
template <typename T>
struct ZeroedAllocator {
  using value_type = T;
  ZeroedAllocator() = default;
  template <typename U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_zeroed(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) { free_zeroed(memory); }
  void construct(T*) {}  // is 0 already
  template <typename U>
  void construct(T* place, const U& value) {
    *place = value;
  }
  bool operator==(const ZeroedAllocator&) const = default;
};

}  // namespace detail

/// Undirected simple graph, one bit a vertex pair: row v holds the neighbours of v.
///
/// Invariants: symmetric, no loops, bits past the last vertex are 0.
/// Memory: `bytes_required(n)`, about n^2 / 8.
class BitsetGraph {
 public:
  using Word = std::uint64_t;                ///< bit j of word i: vertex 64 i + j
  static constexpr Index kBitsPerWord = 64;  ///< vertices of a `Word`

  /// Graph without edges.
  /// @throws std::invalid_argument where `num_vertices` < 0.
  explicit BitsetGraph(Index num_vertices = 0);

  /// Bytes that the adjacency of a graph with `num_vertices` vertices takes.
  static std::size_t bytes_required(Index num_vertices);

  Index num_vertices() const { return num_vertices_; }    ///< they are 0 to this - 1
  Index words_per_row() const { return words_per_row_; }  ///< length of `row`
  Index num_edges() const;                                ///< counted: O(n^2 / 64)
  Index degree(Index v) const;                            ///< counted: O(n / 64)
  /// Whether u and v are neighbours; both in range, which is not checked.
  bool has_edge(Index u, Index v) const {
    return (row(u)[static_cast<std::size_t>(v / kBitsPerWord)] >> (v % kBitsPerWord)) & 1u;
  }

  /// Adds the edge {u, v}.
  /// @throws std::invalid_argument where u == v or a vertex is out of range.
  void add_edge(Index u, Index v);

  /// Neighbours of v, one bit each.
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
  std::vector<Word, detail::ZeroedAllocator<Word>> words_;  // sized once
};

}  // namespace gmcr
