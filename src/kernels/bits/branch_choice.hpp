#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gmcr/types.hpp"
#include "kernels/bits/aligned_words.hpp"

namespace gmcr::kernels {

/// Words that a row of `num_bits` bits takes so that whole vectors cover it.
inline Index padded_words(Index num_bits) {
  const Index words = (num_bits + 63) / 64;
  return words <= 4 ? 4 : (words + 7) / 8 * 8;
}

/// What a node of a clique search asks: which of its candidates it must branch on.
///
/// Rows have `num_words` = padded_words(number of vertices) words, 64 bytes aligned; bits past the
/// last vertex are 0.
struct BranchInput {
  const std::uint64_t* rows = nullptr;        ///< neighbours of each vertex
  const std::uint64_t* candidates = nullptr;  ///< one row
  Index num_words = 0;
  Index max_classes = 0;         ///< that a colouring may use
  bool repairs = false;          ///< whether to try to save branches
  Index max_repair_work = 0;     ///< word operations that the repairs may take
  std::span<const Index> seeds;  ///< seeds[i] opens class i where it is uncoloured

  /// Called now and then with the word operations done since; false ends the work early.
  std::function<bool(Index num_words)> spend;
};

/// A vertex that a search node must branch on.
struct Branch {
  std::int32_t vertex;
  std::int32_t bound;  ///< cliques of this vertex, the earlier branches and the rest are no larger
};

/// Memory for a choice, of any content, reused from one to the next.
struct BranchScratch {
  AlignedWords uncoloured, free, in_use, compatible;                              ///< one row each
  std::vector<std::uint64_t> members, compatible_members, other_members;          ///< one a class
  std::vector<std::int32_t> first_member, unit_vertices, unit_classes, involved;  ///< one a class
  std::vector<std::int32_t> class_of, next_member, removed_by;                    ///< one a vertex
  std::vector<Branch> branches;                                                   ///< one a vertex

  /// Suffices for graphs of so many vertices from now on.
  void resize(Index num_vertices);
};

/// The candidates that a node must branch on.
struct BranchChoice {
  /// By ascending bound; valid until the scratch is used again. The candidates that are not listed
  /// have no clique of more than max_classes vertices.
  std::span<const Branch> branches;
  bool is_clique = false;  ///< whether the candidates are one
};

/// Colours the candidates and lists those that must be branched on.
///
/// The classes are those of a greedy colouring. What no class takes is repaired where possible: one
/// conflicting neighbour moves to another class (Tomita et al. 2010), or unit propagation finds
/// classes that cannot all have a vertex in a clique with it, each of which counts once (Li and
/// Quan 2010). All instruction sets give the same branches.
BranchChoice choose_branches(const BranchInput& input, BranchScratch& scratch);

/// next = here & neighbours. @return the number of its bits. `num_words` as in `BranchInput`.
Index intersect(const std::uint64_t* here, const std::uint64_t* neighbours, Index num_words,
                std::uint64_t* next);

}  // namespace gmcr::kernels
