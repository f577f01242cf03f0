#pragma once

#include <span>

#include "gmcr/bitset_graph.hpp"

namespace gmcr::test {

/// Clique number by trying every vertex subset, for at most 24 vertices.
Index brute_force_clique_number(const BitsetGraph& graph);

/// Clique number according to igraph.
Index igraph_clique_number(const BitsetGraph& graph);

/// Clique number according to cliquer.
Index cliquer_clique_number(const BitsetGraph& graph);

/// Weight of the heaviest clique by trying every vertex subset, for at most 20 vertices.
double brute_force_clique_weight(const BitsetGraph& graph, std::span<const double> weights);

/// Weight of the heaviest clique according to cliquer; `weights` > 0.
Index cliquer_clique_weight(const BitsetGraph& graph, std::span<const int> weights);

}  // namespace gmcr::test
