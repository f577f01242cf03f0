#pragma once

#include "gmcr/bitset_graph.hpp"

namespace gmcr {

/// Makes a graph symmetric whose rows are right from the block of 64 columns that holds their
/// diagonal on: the words left of it are written from those. Cost O(N^2 / 64).
void mirror_upper_blocks(BitsetGraph& graph, int num_threads);

}  // namespace gmcr
