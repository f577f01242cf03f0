#pragma once

#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// Improves `clique` by swaps: one member for two vertices that only it conflicts with, and forced
/// vertices to leave a local optimum (iterated local search of Andrade, Resende and Werneck 2012,
/// on the complement).
///
/// Meant for nearly complete graphs: the cost of a swap is that of the complement degrees.
/// @param max_work  steps after which it ends; also ends when `budget` is spent.
/// @return a clique with at least as many vertices.
/// Deterministic: the choices come from a generator with a fixed seed.
std::vector<Index> improve_by_swaps(RowsView graph, std::span<const Index> clique, Index max_work,
                                    SearchBudget& budget);

}  // namespace gmcr::clique
