#pragma once

#include <cstdint>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Words that a row of `num_bits` bits takes so that whole vectors cover it.
inline Index padded_words(Index num_bits) {
  const Index words = (num_bits + 63) / 64;
  return words <= 4 ? 4 : (words + 7) / 8 * 8;
}

/// The vertices that a node of a clique search must branch on, and the memory to find them.
///
/// Rows have `num_words` = padded_words(number of vertices) words, 64 bytes aligned; bits past the
/// last vertex are 0.
struct BranchChoice {
  const std::uint64_t* rows = nullptr;        ///< neighbours of each vertex
  const std::uint64_t* candidates = nullptr;  ///< one row
  Index num_words = 0;
  Index max_classes = 0;         ///< that a colouring may use
  bool repairs = false;          ///< whether to try to save branches
  Index max_repair_work = 0;     ///< word operations that the repairs may take
  const Index* seeds = nullptr;  ///< seeds[i] opens class i where it is uncoloured
  Index num_seeds = 0;

  /// Called now and then with the word operations done since; false ends the work early.
  bool (*spend)(void* budget, Index num_words) = nullptr;
  void* budget = nullptr;

  // memory of the caller
  std::uint64_t* uncolored = nullptr;  ///< one row, as the next three
  std::uint64_t* free = nullptr;
  std::uint64_t* in_use = nullptr;
  std::uint64_t* compatible = nullptr;
  std::uint64_t* members = nullptr;  ///< max_classes entries, as the next six
  std::uint64_t* compatible_members = nullptr;
  std::uint64_t* other_members = nullptr;
  std::int32_t* first_member = nullptr;
  std::int32_t* unit_vertices = nullptr;
  std::int32_t* unit_classes = nullptr;
  std::int32_t* involved = nullptr;
  std::int32_t* class_of = nullptr;  ///< one a vertex, as the next four
  std::int32_t* next_member = nullptr;
  std::int32_t* removed_by = nullptr;
  std::int32_t* branch_vertices = nullptr;
  std::int32_t* branch_bounds = nullptr;

  // results
  Index num_branches = 0;
  bool is_clique = false;  ///< whether the candidates are one
};

/// Colours the candidates and lists those that must be branched on, by ascending bound:
/// branch_bounds[i] bounds the cliques of the branch vertices 0 ... i and the candidates that are
/// no branches; the latter have no clique of more than max_classes vertices.
///
/// The classes are those of a greedy colouring. What no class takes is repaired where possible: one
/// conflicting neighbour moves to another class (Tomita et al. 2010), or unit propagation finds
/// classes that cannot all have a vertex in a clique with it, each of which counts once (Li and
/// Quan 2010). All instruction sets give the same branches.
void choose_branches(BranchChoice& choice);

/// next = here & neighbors. @return the number of its bits. `num_words` as in `BranchChoice`.
Index intersect(const std::uint64_t* here, const std::uint64_t* neighbors, Index num_words,
                std::uint64_t* next);

}  // namespace gmcr::kernels
