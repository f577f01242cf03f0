#pragma once

#include <span>
#include <vector>

#include "clique/bit_rows.hpp"

namespace gmcr {

/// Maximal clique grown from `start`: always adds the candidate of highest priority.
///
/// @param start     a vertex of `graph`.
/// @param priority  one value a vertex, or empty: all equal. Ties go to the smallest index.
/// @return the clique, ascending; it contains `start`.
/// @throws std::invalid_argument where `start` or the size of `priority` is out of range.
/// Deterministic. Cost O(d log d + c n / 64) for d neighbours of `start` and a clique of c.
std::vector<Index> greedy_clique(RowsView graph, Index start, std::span<const Index> priority);

/// As `greedy_clique`, but as soon as at most `max_candidates` candidates are left, adds the one
/// with the most neighbours among them (ties: as listed by priority).
///
/// @param allowed  bit mask of the vertices that may join `start`; empty: all. With a mask the
///                 clique is maximal among these.
/// Finds larger cliques than `greedy_clique` where many candidates fit few others.
/// Cost: that of `greedy_clique`, and O(max_candidates^2).
std::vector<Index> greedy_clique_by_candidates(RowsView graph, Index start,
                                               std::span<const Index> priority,
                                               Index max_candidates = 1024,
                                               std::span<const Word> allowed = {});

}  // namespace gmcr
