#include "consensus/binned_pairs.hpp"

#include <numeric>

namespace gmcr {

std::optional<BinnedPairs> BinnedPairs::make(const kernels::CorrespondenceArrays& arrays,
                                             const ScaleBins& bins, const ScaleVotes& votes,
                                             std::size_t max_bytes) {
  BinnedPairs binned;
  binned.num_correspondences_ = arrays.size();
  binned.offsets_.push_back(0);
  for (const Index count : votes.pairs) {
    binned.offsets_.push_back(binned.offsets_.back() + static_cast<std::size_t>(count));
  }
  if (binned.offsets_.back() > max_bytes / sizeof(Pair)) return std::nullopt;

  binned.pairs_.resize(binned.offsets_.back());
  std::vector<std::size_t> next(binned.offsets_.begin(), binned.offsets_.end() - 1);
  for_each_voting_pair(
      arrays, bins, 0, arrays.size(), [&](Index i, Index j, Index first_bin, Index last_bin) {
        const Pair pair{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)};
        for (Index bin = first_bin; bin <= last_bin; ++bin) {
          binned.pairs_[next[static_cast<std::size_t>(bin)]++] = pair;
        }
      });
  return binned;
}

BitsetGraph BinnedPairs::graph(Index bin) const {
  BitsetGraph graph(num_correspondences_);
  const auto b = static_cast<std::size_t>(bin);
  for (std::size_t k = offsets_[b]; k < offsets_[b + 1]; ++k) {
    graph.add_edge(pairs_[k].first, pairs_[k].second);
  }
  return graph;
}

}  // namespace gmcr
