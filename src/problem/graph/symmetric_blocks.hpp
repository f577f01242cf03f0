#pragma once

#include <functional>

#include "gmcr/bitset_graph.hpp"
#include "kernels/bits/bit_block.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::problem {

/// Writes a graph from the blocks of 64 x 64 vertices on and above its diagonal.
/// @param block  block(row_block, column_block), row_block <= column_block: bits past the last
///     vertex are 0, and a block on the diagonal is symmetric without loops. Called from several
///     threads.
/// Where the deadline passes first, blocks are missing, with their mirror images. Cost O(N^2 / 64).
void write_symmetric_blocks(BitsetGraph& graph, int num_threads, const parallel::Deadline& deadline,
                            const std::function<kernels::BitBlock(Index, Index)>& block);

/// Makes a graph symmetric whose rows are right from the block of 64 columns that holds their
/// diagonal on: the words left of it are written from those. Where the deadline passes before the
/// end, all edges are removed. Cost O(N^2 / 64).
void mirror_upper_blocks(BitsetGraph& graph, int num_threads,
                         const parallel::Deadline& deadline = parallel::Deadline::never());

}  // namespace gmcr::problem
