#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "search/scales/voted_bins.hpp"

namespace gmcr::search {

/// Branch and bound over the scale (L5).
class ScaleBranchAndBound {
 public:
  /// A tighter proven bound on the measure of poses in a range than the given one, by whatever it
  /// tries; nullopt: it tries nothing any more.
  using Tighten =
      std::function<std::optional<double>(const RangeGraph&, Measure, double upper_bound)>;

  /// Starts with the bins. Keeps the references.
  ScaleBranchAndBound(PoseSearch& search, VotedBins& voted);

  /// Searches the graphs of the ranges of largest bound on a measure for cliques; halves those
  /// whose bound stays above what is to be beaten, until none does, no halving can lower the
  /// largest bound or the number of graphs is spent.
  /// @param tighten  tried on each range after the cliques, and halving goes on below the bounds
  ///   that pairs of correspondences give; null: none.
  /// @return upper bound on the measure of any pose.
  double lower_upper_bound(Measure measure, const Tighten& tighten = nullptr);

 private:
  /// A range of scales and the most that a pose in it can have.
  struct Range {
    ScaleRange scales;
    Index bin = 0;  ///< that it is part of
    PerMeasure bounds;
    std::vector<Index> clique;  ///< of most inliers that its search met; empty: none
    bool searched[2] = {};      ///< by cliques, for each measure
    bool tightened[2] = {};     ///< for each measure
  };

  /// What the clique searches of a range found, where they were needed.
  struct Cliques {
    bool asks_for_inliers = false;
    std::optional<problem::Run::Clique> inliers, evidence;
  };

  /// Ranges that are searched side by side, each for more than what was to be beaten before.
  using Round = std::span<Range>;

  static bool is_less(const Range& a, const Range& b, Measure measure);
  void halve_front(Measure measure);

  /// Takes the ranges of largest bound off the heap, to its end.
  Round take_round(Index most, Measure measure, bool with_tightening);

  /// @return whether `tighten`, if any, goes on.
  bool search_round(Round round, Measure measure, const Tighten& tighten);
  Cliques find_cliques(const Range& range, const RangeGraph& graph, Measure measure,
                       int num_threads) const;
  void take_cliques(Range& range, Measure measure, Cliques found);
  bool asks_for_inliers(const Range& range, Measure measure) const;
  bool is_done(const Range& range, Measure measure, bool with_tightening) const;
  bool is_at_floor(const Range& range, Measure measure) const;

  PoseSearch& search_;
  VotedBins& voted_;
  std::vector<Range> ranges_;
};

}  // namespace gmcr::search
