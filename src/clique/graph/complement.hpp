#pragma once

#include <cstdint>
#include <vector>

#include "clique/graph/bit_rows.hpp"

namespace gmcr::clique {

/// For each vertex of a nearly complete graph the vertices that it is not adjacent to, ascending.
using ComplementLists = std::vector<std::vector<std::int32_t>>;

/// Cost O(n^2 / 64) and the length of the lists.
ComplementLists complement_lists(RowsView graph);

/// Whether so few vertex pairs are no edges that the work on the complement pays.
bool is_nearly_complete(RowsView graph);

}  // namespace gmcr::clique
