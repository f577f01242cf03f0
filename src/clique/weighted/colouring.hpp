#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// A vertex that a search node must branch on.
struct WeightedBranch {
  Index vertex;
  std::int64_t bound;  ///< cliques of this vertex, the earlier branches and the rest weigh no more
};

/// Whether the weight of a vertex may be spread over several classes of a colouring.
enum class Splitting {
  None,  ///< fast: each vertex is coloured once
  Full   ///< tight
};

/// Bounds the weight of the cliques of a graph by weighted colourings.
///
/// A class is an independent set; it takes a part of the weight of each of its vertices and costs
/// the largest part. A vertex may be split over several classes (Held, Cook and Sewell 2012;
/// Tavares et al. 2015). A clique has at most one vertex in each class, so it weighs no more than
/// the classes that its vertices are spread over cost.
class WeightedColoring {
 public:
  /// Word operations that a colouring of so many vertices may take.
  static std::uint64_t most_work(Index num_vertices, Index words_per_row) {
    return static_cast<std::uint64_t>(kMaxSplitEffort * num_vertices * words_per_row);
  }

  /// Works on `graph` from now on.
  /// @param units   one weight a vertex, > 0 where it is ever a candidate; outlives this use.
  /// @param budget  outlives this use.
  void reset(RowsView graph, std::span<const std::int64_t> units, SearchBudget& budget);

  /// Appends the branches within `candidates` to `branches`, by ascending bound.
  ///
  /// The candidates that are not appended have no clique that weighs more than `max_pruned`.
  /// Low numbers are coloured first. Once the budget is spent, all that is not coloured yet becomes
  /// a branch. Cost O(k n / 64) for k of n vertices; with splitting up to 64 times as much.
  /// @return whether the candidates are a clique.
  bool select(const Word* candidates, std::int64_t max_pruned, Splitting splitting,
              std::vector<WeightedBranch>& branches);

  /// Whether classes without splitting that cost `max_units` together suffice for the `candidates`;
  /// then no clique of them weighs more. False once the budget is spent.
  bool covers(const Word* candidates, std::int64_t max_units);

  /// What the classes of a colouring without splitting cost: no clique of `candidates` weighs more.
  /// The heaviest come first, so that a class has vertices of about the same weight.
  /// Cost O(k (n / 64 + number of classes)) for k of n vertices.
  std::int64_t bound(const Word* candidates);

 private:
  // Colourings that split may cost as much as this many that do not; then they stop splitting.
  static constexpr Index kMaxSplitEffort = 64;

  void start(const Word* candidates, Splitting splitting);
  void take_class();

  RowsView graph_;
  std::span<const std::int64_t> units_;
  SearchBudget* budget_ = nullptr;
  Index first_word_ = 0;         // no vertex is left in the words before
  Index split_words_left_ = 0;   // word operations that classes which split may still take
  std::int64_t cost_ = 0;        // of all classes so far
  std::vector<Word> uncolored_;  // vertices with weight left
  std::vector<Word> free_;
  std::vector<std::int64_t> left_;  // weight that no class has taken yet
  std::vector<Index> class_;        // the latest class
  Index num_done_ = 0;              // its first vertices, which have no weight left
};

}  // namespace gmcr::clique
