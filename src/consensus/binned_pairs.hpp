#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "consensus/scale_bins.hpp"
#include "gmcr/bitset_graph.hpp"
#include "kernels/consistency_row.hpp"

namespace gmcr {

/// The pairs that agree in each bin of scales, so that the graph of a bin is built from its own
/// pairs and not from all.
class BinnedPairs {
 public:
  /// @param votes  of the same correspondences and bins.
  /// @return nullopt where the lists would take more than `max_bytes`.
  /// Cost O(N^2 + number of votes).
  static std::optional<BinnedPairs> make(const kernels::CorrespondenceArrays& arrays,
                                         const ScaleBins& bins, const ScaleVotes& votes,
                                         std::size_t max_bytes);

  /// The consistency graph of a bin; may hold pairs that only touch it. Cost O(N^2 / 64 + its
  /// pairs).
  BitsetGraph graph(Index bin) const;

 private:
  struct Pair {
    std::uint32_t first, second;
  };

  Index num_correspondences_ = 0;
  std::vector<std::size_t> offsets_;  ///< of each bin into pairs_, and the end
  std::vector<Pair> pairs_;
};

}  // namespace gmcr
