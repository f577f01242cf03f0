#pragma once

#include <vector>

#include "clique/graph/candidate_rows.hpp"
#include "clique/graph/search_budget.hpp"
#include "clique/weighted/colouring.hpp"
#include "clique/weighted/fixed_point_weights.hpp"

namespace gmcr::clique {

/// Exact search for a clique heavier than a known one, in a graph small enough for a bit row per
/// level. As `BranchAndBound`, with weights.
class WeightedBranchAndBound {
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
                 WeightRounding rounding, SearchBudget& budget);

 private:
  struct Level {
    std::size_t first_branch;  // its branches lie there and behind, up to those of the next level
    std::int64_t weight;       // of the vertices chosen so far
    std::int64_t bound;        // on the cliques here, chosen vertices included
  };

  void enter_level(std::int64_t weight, std::int64_t bound);
  void leave_level();
  void visit_next_branch();
  void record_clique(const Word* rest);
  std::int64_t branch_bound() const { return levels_.back().weight + branches_.back().bound; }
  std::int64_t unfinished_bound() const;
  Index words_per_node() const { return graph_.num_vertices * graph_.words_per_row; }

  RowsView graph_;
  std::span<const std::int64_t> units_;
  WeightedColoring coloring_;
  WeightRounding rounding_;
  std::int64_t to_beat_ = 0;
  std::vector<Index> best_clique_;
  std::vector<Index> chosen_;  // the vertex that leads from each level to the next
  CandidateRows candidates_;
  std::vector<Level> levels_;
  std::vector<WeightedBranch> branches_;  // of all levels, the deepest last
};

}  // namespace gmcr::clique
