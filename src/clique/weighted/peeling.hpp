#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/graph/bit_rows.hpp"
#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {

/// Drops the vertices whose neighbourhood is too light for a clique of interest.
///
/// A clique with vertex v weighs no more than v and its neighbours. What is dropped makes other
/// neighbourhoods lighter: the weighted form of the core of a graph.
class WeightedPeeling {
 public:
  /// Starts with the vertices of positive weight, less those whose neighbours are too few to weigh
  /// more than `to_beat` even if each were as heavy as the heaviest.
  /// @param units   one weight a vertex; outlives this use.
  /// @param budget  outlives this use. Once it is spent, neighbourhoods are only bounded.
  /// Cost O(n^2 / 64) and the edges of the vertices left.
  void reset(RowsView graph, std::span<const std::int64_t> units, std::int64_t to_beat,
             SearchBudget& budget, int num_threads = 1);

  /// Drops vertices until every neighbourhood left weighs more than `to_beat`, or the budget ends.
  /// No clique that weighs more loses a vertex. Cost O(e + k n / 64) for k vertices dropped, with e
  /// edges.
  void peel(std::int64_t to_beat);

  const std::vector<Word>& alive() const { return alive_; }
  Index num_alive() const { return num_alive_; }

  /// For each vertex, an upper bound on the weight of it and its neighbours that are left.
  std::span<const std::int64_t> neighborhoods() const { return neighborhood_; }

  /// No clique of the vertices left weighs more; 0 where none is left.
  std::int64_t heaviest_neighborhood() const;

 private:
  void drop_few_neighbors(std::int64_t to_beat);
  void sum_neighborhoods();
  void drop_light(std::int64_t to_beat);
  void drop(Index v);

  RowsView graph_;
  std::span<const std::int64_t> units_;
  SearchBudget* budget_ = nullptr;
  int num_threads_ = 1;
  Index num_alive_ = 0;
  std::vector<Word> alive_;
  std::vector<std::int64_t> neighborhood_;
  std::vector<Index> dropped_;  // whose neighbours do not know it yet
};

}  // namespace gmcr::clique
