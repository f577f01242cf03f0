#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/bitset_graph.hpp"
#include "parallel/deadline.hpp"
#include "search/scales/scale_votes.hpp"

namespace gmcr::search {

/// The pairs that agree in each of some bins of scales, so that the graph of a bin is built from
/// its own pairs and not from all.
class BinnedPairs {
 public:
  /// No bins.
  BinnedPairs() = default;

  /// How many of the bins, in this order, have lists that fit into `max_bytes`; none where the
  /// deadline passed while the votes were counted.
  static std::size_t num_that_fit(const ScaleVotes& votes, std::span<const Index> wanted,
                                  std::size_t max_bytes);

  /// Lists the pairs of the bins; of none where the deadline passes first.
  /// @param votes  of the same correspondences and bins, counted in time.
  /// The same for any number of threads. Cost O(N^2 + number of votes).
  BinnedPairs(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
              const ScaleVotes& votes, std::span<const Index> wanted, int num_threads,
              const parallel::Deadline& deadline = parallel::Deadline::never());

  bool contains(Index bin) const;

  /// The consistency graph of a bin that is contained, or of a part of it; of a whole bin it may
  /// hold pairs that only touch that. Cost O(N^2 / 64 + pairs of the bin).
  BitsetGraph graph(const geometry::CorrespondenceArrays& arrays, Index bin,
                    const ScaleRange& scales, int num_threads) const;

 private:
  void list_chunk(const geometry::CorrespondenceArrays& arrays, const kernels::ScaleCells& cells,
                  std::size_t chunk);

  std::size_t num_chunks_ = 0;
  /// Number of listed bins below each bin, and of all.
  std::vector<std::size_t> lists_below_;
  std::vector<ScaleRange> ranges_;    ///< of the listed bins
  std::vector<std::size_t> offsets_;  ///< of each list and chunk of rows into pairs_, and the end
  std::vector<std::uint32_t> pairs_;  ///< row in its chunk above bit 26, column
};

}  // namespace gmcr::search
