#pragma once

#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"

namespace gmcr::clique {

class SearchBudget;

/// Proper colouring of some vertices of a graph: no two neighbours share a colour, so no clique
/// of them has more vertices than there are colours.
struct Coloring {
  std::vector<Index> order;  ///< the coloured vertices, by ascending colour
  std::vector<Index> color;  ///< color[i]: colour of order[i], 0, 1, ...
  Index num_colors = 0;
};

/// Greedy sequential colouring, one colour class after the other (San Segundo et al. 2011).
///
/// @param subset  bit mask of the vertices to colour.
/// @param seeds   vertices of the subset, distinct: seeds[i] opens class i where it is still
///                uncoloured. A known clique as seeds makes the classes fit it.
/// @param budget  null: none. Once it is spent, each vertex left gets a colour of its own.
/// Deterministic. Cost O(k n / 64) for k vertices of n.
Coloring color_greedily(RowsView graph, std::span<const Word> subset,
                        std::span<const Index> seeds = {}, SearchBudget* budget = nullptr);

/// Colours at most `max_colors` classes; whether that coloured all of `subset`. True proves that
/// the subset has no clique of more vertices.
/// @param scratch  any content; reused memory.
/// @param budget   null: none. False once it is spent.
bool colors_with(RowsView graph, std::span<const Word> subset, Index max_colors,
                 std::vector<Word>& scratch, SearchBudget* budget = nullptr);

}  // namespace gmcr::clique
