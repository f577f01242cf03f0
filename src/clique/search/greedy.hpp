#pragma once

#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"

namespace gmcr::clique {

/// Maximal clique grown from `start`: always adds the candidate of highest priority, but as soon as
/// at most `max_candidates` are left, the one with the most neighbours among them. That finds
/// larger cliques where many candidates fit few others.
///
/// @param start     a vertex of `graph`.
/// @param priority  one value a vertex, or empty: all equal. Ties go to the smallest index, among
///                  the last candidates to the highest priority.
/// @param allowed   bit mask of the vertices that may join `start`; empty: all. With a mask the
///                  clique is maximal among these.
/// @return the clique, ascending; it contains `start`.
/// @throws std::invalid_argument where `start` or the size of `priority` is out of range.
/// Deterministic. Cost O(d log d + c n / 64 + max_candidates^2) for d neighbours of `start` and a
/// clique of c.
std::vector<Index> greedy_clique(RowsView graph, Index start, std::span<const Index> priority,
                                 Index max_candidates = 1024, std::span<const Word> allowed = {});

}  // namespace gmcr::clique
