#pragma once

#include <optional>
#include <vector>

#include "search/binned_pairs.hpp"
#include "search/incumbent.hpp"
#include "search/scale_bins.hpp"
#include "search/scale_votes.hpp"

namespace gmcr::search {

/// The bins of scales, what the pairs say of them, and their graphs.
class VotedBins {
 public:
  /// Counts the votes.
  explicit VotedBins(PoseSearch& search);

  const ScaleBins& bins() const { return bins_; }
  const ScaleVotes& votes() const { return votes_; }

  /// Most that a pose at a scale of the bin can have, by the pairs that vote for it.
  UpperBounds bounds(Index bin) const {
    const auto b = static_cast<std::size_t>(bin);
    return {votes_.max_members[b], votes_.max_evidence[b]};
  }

  /// The graph of a part of a bin, from the list of its pairs or from all of them.
  RangeGraph graph(PoseSearch& search, Index bin, const ScaleRange& scales);

 private:
  bool is_listable(Index bin) const;
  void list_pairs(PoseSearch& search, Index first_bin);

  ScaleBins bins_;
  ScaleVotes votes_;
  BinnedPairs pairs_;
  Index num_pairs_ = 0;     ///< of all correspondences
  Index num_unlisted_ = 0;  ///< graphs of listable bins from all pairs since pairs were listed
};

/// Branch and bound over the scale.
class ScaleRanges {
 public:
  /// Starts with the bins. Keeps the references.
  ScaleRanges(PoseSearch& search, VotedBins& voted);

  /// Searches the graphs of the ranges of largest bound on a measure, by cliques and, as long as
  /// the deadline allows, jointly; halves those whose bound stays above what is to be beaten, until
  /// none does or the number of graphs is spent.
  /// @return upper bound on the measure of any pose.
  double lower(Measure measure, bool jointly);

 private:
  /// A range of scales and the most that a pose in it can have.
  struct Range {
    ScaleRange scales;
    Index bin = 0;  ///< that it is part of
    UpperBounds bounds;
    UpperBounds floors{0, 0};  ///< that no halving brings the bounds below
    bool searched[2] = {};     ///< by cliques, for each measure
    bool tightened[2] = {};    ///< jointly, for each measure
  };

  void search_range(Range& range, Measure measure, const parallel::Deadline* deadline);
  void search_inliers(Range& range, const RangeGraph& graph);
  void search_evidence(Range& range, const RangeGraph& graph);
  bool is_done(const Range& range, Measure measure, bool jointly) const;

  PoseSearch& search_;
  VotedBins& voted_;
  std::vector<Range> ranges_;
};

}  // namespace gmcr::search
