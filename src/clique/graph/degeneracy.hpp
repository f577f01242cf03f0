#pragma once

#include <vector>

#include "clique/graph/bit_rows.hpp"

namespace gmcr::clique {

class SearchBudget;

/// Smallest-last order of the vertices of a graph and what it proves.
struct Degeneracy {
  std::vector<Index> order;  ///< each vertex has the fewest neighbours among itself and the later
  std::vector<Index>
      core;              ///< core[v]: core number of v; a clique with v has <= core[v] + 1 vertices
  Index degeneracy = 0;  ///< largest core number, 0 for a graph without edges
};

/// Degeneracy order and core numbers by a bucket queue (Matula and Beck 1983; Batagelj and
/// Zaversnik 2003).
///
/// @param budget  null: none. Once it is spent, the order of the vertices left is arbitrary, and
///                what `core` and `degeneracy` hold are upper bounds on the core numbers.
/// Deterministic. Cost O(E + n^2 / 64) for n vertices and E edges.
Degeneracy degeneracy_order(RowsView graph, SearchBudget* budget = nullptr);

}  // namespace gmcr::clique
