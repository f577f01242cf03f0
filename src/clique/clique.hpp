#pragma once

#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/colouring.hpp"
#include "clique/graph/degrees.hpp"
#include "clique/search/greedy.hpp"

/// What the other folders of src/ use of this one beside the public `max_clique` and
/// `max_weight_clique`: rows of bits, colourings, degrees, greedy cliques, and what stands here.
/// They include nothing else of it.

namespace gmcr::clique {

/// The subgraph of `graph` that `vertices` induce, as a graph of its own; vertex i of it is
/// `vertices[i]`.
BitsetGraph induced_subgraph(const BitsetGraph& graph, std::span<const Index> vertices);

/// The vertices by descending core number (the degeneracy order backwards): colourings that take
/// them in this order need few colours.
///
/// Deterministic. Cost O(E + n^2 / 64) for n vertices and E edges.
std::vector<Index> core_order(const BitsetGraph& graph);

}  // namespace gmcr::clique
