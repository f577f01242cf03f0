#pragma once

#include "gmcr/bitset_graph.hpp"

namespace gmcr::test {

/// Clique number by trying every vertex subset, for at most 24 vertices.
Index brute_force_clique_number(const BitsetGraph& graph);

/// Clique number according to igraph.
Index igraph_clique_number(const BitsetGraph& graph);

/// Clique number according to cliquer.
Index cliquer_clique_number(const BitsetGraph& graph);

}  // namespace gmcr::test
