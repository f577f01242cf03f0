#pragma once

#include "search/candidate_cliques.hpp"
#include "search/scales/binned_pairs.hpp"
#include "search/scales/scale_bins.hpp"
#include "search/scales/scale_votes.hpp"

namespace gmcr::search {

/// The bins of scales, what the pairs say of them, and their graphs.
class VotedBins {
 public:
  /// Counts the votes, of few correspondences only at the scales where the best pose so far may be
  /// beaten.
  explicit VotedBins(PoseSearch& search);

  const ScaleBins& bins() const { return bins_; }
  const ScaleVotes& votes() const { return votes_; }

  /// Most that a pose at a scale of the bin can have, by the pairs that vote for it.
  PerMeasure bounds(Index bin) const {
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

}  // namespace gmcr::search
