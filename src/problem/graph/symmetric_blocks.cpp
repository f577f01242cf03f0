#include "problem/graph/symmetric_blocks.hpp"

#include <algorithm>

#include "parallel/parallel_for.hpp"

namespace gmcr::problem {
namespace {

constexpr Index kBlock = BitsetGraph::kBitsPerWord;
constexpr Index kSide = 4;  // blocks: what a square of them writes fits the first-level cache

/// Calls body(row_block, column_block) for all pairs of blocks with row_block <= column_block, in
/// squares of kSide x kSide blocks: neighbouring words of a row, above and below the diagonal, are
/// written while their cache line is near.
template <typename Body>
void for_each_upper_block(const BitsetGraph& graph, int num_threads,
                          const parallel::Deadline& deadline, const Body& body) {
  const Index num_blocks = graph.words_per_row(), num_squares = (num_blocks + kSide - 1) / kSide;
  const int threads = parallel::threads_for_pairs(graph.num_vertices(), num_threads);
  parallel::parallel_for(num_squares * num_squares, 1, threads, [&](Index square, Index) {
    const Index row = square / num_squares, column = square % num_squares;
    if (row > column || deadline.expired()) return;
    const Index row_end = std::min((row + 1) * kSide, num_blocks);
    const Index column_end = std::min((column + 1) * kSide, num_blocks);
    for (Index r = row * kSide; r < row_end; ++r) {
      for (Index c = std::max(r, column * kSide); c < column_end; ++c) body(r, c);
    }
  });
}

/// Brings in the memory of a new graph, each thread that of rows side by side: threads that write
/// to blocks would often wait for each other at one page.
void touch_rows(BitsetGraph& graph, int num_threads, const parallel::Deadline& deadline) {
  constexpr Index kChunk = 1024;
  constexpr std::size_t kWordsPerPage = 512;
  if (graph.num_vertices() <= kChunk) return;
  parallel::parallel_for(graph.num_vertices(), kChunk, num_threads, [&](Index begin, Index end) {
    if (deadline.expired()) return;
    for (Index v = begin; v < end; ++v) {
      const auto row = graph.mutable_row(v);
      for (std::size_t word = 0; word < row.size(); word += kWordsPerPage) row[word] = 0;
    }
  });
}

kernels::BitBlock read_block(const BitsetGraph& graph, Index row_block, Index column_block) {
  kernels::BitBlock bits{};
  const Index begin = row_block * kBlock, end = std::min(begin + kBlock, graph.num_vertices());
  for (Index v = begin; v < end; ++v) {
    bits[static_cast<std::size_t>(v - begin)] =
        graph.row(v)[static_cast<std::size_t>(column_block)];
  }
  return bits;
}

void write_block(BitsetGraph& graph, Index row_block, Index column_block,
                 const kernels::BitBlock& bits) {
  const Index begin = row_block * kBlock, end = std::min(begin + kBlock, graph.num_vertices());
  for (Index v = begin; v < end; ++v) {
    graph.mutable_row(v)[static_cast<std::size_t>(column_block)] =
        bits[static_cast<std::size_t>(v - begin)];
  }
}

/// As write_block, but pages of a new graph that no edge reaches are never brought in.
void change_block(BitsetGraph& graph, Index row_block, Index column_block,
                  const kernels::BitBlock& bits) {
  if (read_block(graph, row_block, column_block) == bits) return;
  write_block(graph, row_block, column_block, bits);
}

}  // namespace

void write_symmetric_blocks(BitsetGraph& graph, int num_threads, const parallel::Deadline& deadline,
                            const std::function<kernels::BitBlock(Index, Index)>& block) {
  touch_rows(graph, num_threads, deadline);
  for_each_upper_block(graph, num_threads, deadline, [&](Index row, Index column) {
    kernels::BitBlock bits = block(row, column);
    write_block(graph, row, column, bits);
    if (row == column) return;
    kernels::transpose(bits);
    write_block(graph, column, row, bits);
  });
}

void mirror_upper_blocks(BitsetGraph& graph, int num_threads, const parallel::Deadline& deadline) {
  for_each_upper_block(graph, num_threads, deadline, [&](Index row, Index column) {
    if (row == column) return;
    kernels::BitBlock bits = read_block(graph, row, column);
    kernels::transpose(bits);
    change_block(graph, column, row, bits);
  });
  if (deadline.expired()) graph = BitsetGraph(graph.num_vertices());
}

}  // namespace gmcr::problem
