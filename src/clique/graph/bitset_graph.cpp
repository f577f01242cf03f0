#include "gmcr/bitset_graph.hpp"

#include <sys/mman.h>

#include <bit>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

namespace gmcr {
namespace detail {

void* allocate_zeroed(std::size_t bytes) {
  constexpr std::size_t kPage = 4096, kLarge = std::size_t{4} << 20;
  void* const memory = std::calloc(1, bytes);
  if (memory == nullptr && bytes != 0) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (bytes >= kLarge) {  // fewer page faults; only a hint
    const auto first = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / kPage * kPage;
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  }
#endif
  return memory;
}

void free_zeroed(void* memory) noexcept { std::free(memory); }

}  // namespace detail

namespace {

Index words_for(Index num_vertices) {
  return (num_vertices + BitsetGraph::kBitsPerWord - 1) / BitsetGraph::kBitsPerWord;
}

}  // namespace

BitsetGraph::BitsetGraph(Index num_vertices)
    : num_vertices_(num_vertices), words_per_row_(words_for(num_vertices)) {
  if (num_vertices < 0) {
    throw std::invalid_argument("num_vertices: " + std::to_string(num_vertices) + " is negative");
  }
  words_.resize(static_cast<std::size_t>(num_vertices * words_per_row_));
}

std::size_t BitsetGraph::bytes_required(Index num_vertices) {
  return static_cast<std::size_t>(num_vertices) *
         static_cast<std::size_t>(words_for(num_vertices)) * sizeof(Word);
}

Index BitsetGraph::num_edges() const {
  Index twice = 0;
  for (const Word word : words_) twice += std::popcount(word);
  return twice / 2;
}

Index BitsetGraph::degree(Index v) const {
  Index count = 0;
  for (const Word word : row(v)) count += std::popcount(word);
  return count;
}

void BitsetGraph::add_edge(Index u, Index v) {
  if (u < 0 || v < 0 || u >= num_vertices_ || v >= num_vertices_ || u == v) {
    throw std::invalid_argument("edge: {" + std::to_string(u) + ", " + std::to_string(v) +
                                "} is no edge of a graph with " + std::to_string(num_vertices_) +
                                " vertices");
  }
  mutable_row(u)[static_cast<std::size_t>(v / kBitsPerWord)] |= Word{1} << (v % kBitsPerWord);
  mutable_row(v)[static_cast<std::size_t>(u / kBitsPerWord)] |= Word{1} << (u % kBitsPerWord);
}

}  // namespace gmcr
