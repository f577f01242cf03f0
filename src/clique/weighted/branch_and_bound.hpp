#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clique/search/depth_first_search.hpp"
#include "clique/weighted/colouring.hpp"
#include "clique/weighted/fixed_point_weights.hpp"

namespace gmcr::clique {

/// The weight of the vertices, as `DepthFirstSearch` maximises it.
class WeightMeasure {
 public:
  using Value = std::int64_t;
  using Branch = WeightedBranch;

  void reset(RowsView graph, std::span<const std::int64_t> units, WeightRounding rounding,
             SearchBudget& budget) {
    words_ = graph.words_per_row;
    units_ = units;
    rounding_ = rounding;
    colouring_.reset(graph, units, budget);
  }

  std::int64_t value(Index v) const { return units_[v]; }
  std::int64_t to_beat(std::int64_t weight) const { return rounding_.to_beat(weight); }

  std::int64_t sum(const Word* set) const {
    std::int64_t weight = 0;
    for_each_bit(set, words_, [&](Index v) { weight += units_[v]; });
    return weight;
  }

  std::int64_t descend(CandidateRows& candidates, Index level, Index v) const {
    return sum(candidates.descend(level, v));
  }

  bool select(const Word* candidates, std::int64_t max_pruned, SearchBudget&,
              std::vector<Branch>& branches) {
    return colouring_.select(candidates, max_pruned, Splitting::Full, branches);
  }

 private:
  Index words_ = 0;
  std::span<const std::int64_t> units_;
  WeightRounding rounding_;
  WeightedColouring colouring_;
};

/// Exact search for a clique heavier than a known one.
class WeightedBranchAndBound : public DepthFirstSearch<WeightMeasure> {
 public:
  struct Outcome {
    std::vector<Index> clique;     ///< the heaviest above `to_beat`; empty: none met
    std::int64_t upper_bound = 0;  ///< no clique is heavier than this or `to_beat`
  };

  /// Searches `graph`, whose vertices come best first.
  /// @param units    one weight a vertex, > 0.
  /// @param to_beat  units, >= 0.
  /// Ends early when `budget` is spent; the bound is then what is left to prove.
  Outcome search(RowsView graph, std::span<const std::int64_t> units, std::int64_t to_beat,
                 WeightRounding rounding, SearchBudget& budget) {
    measure_.reset(graph, units, rounding, budget);
    begin(graph, to_beat, budget);
    run(budget);
    return {clique(), upper_bound()};
  }
};

}  // namespace gmcr::clique
