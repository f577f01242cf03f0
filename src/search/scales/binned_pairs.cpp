#include "search/scales/binned_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "parallel/parallel_for.hpp"
#include "problem/graph/symmetric_blocks.hpp"

namespace gmcr::search {
namespace {

constexpr Index kRowsPerChunk = ScaleVotes::kRowsPerChunk;
static_assert(kRowsPerChunk == BitsetGraph::kBitsPerWord);
constexpr int kColumnBits = 26;
constexpr std::size_t kFewPairs = 100000;  // starting threads would take longer than these

}  // namespace

std::size_t BinnedPairs::num_that_fit(const ScaleVotes& votes, std::span<const Index> wanted,
                                      std::size_t max_bytes) {
  if (votes.pairs_of_chunks.empty()) return 0;
  std::size_t room = max_bytes / sizeof(std::uint32_t), count = 0;
  for (const Index bin : wanted) {
    const auto num_pairs = static_cast<std::size_t>(votes.pairs[static_cast<std::size_t>(bin)]);
    if (num_pairs > room) break;
    room -= num_pairs;
    ++count;
  }
  return count;
}

BinnedPairs::BinnedPairs(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
                         const ScaleVotes& votes, std::span<const Index> wanted, int num_threads,
                         const parallel::Deadline& deadline) {
  const auto num_bins = static_cast<std::size_t>(bins.size());
  num_chunks_ = votes.pairs_of_chunks.size() / num_bins;
  lists_below_.assign(num_bins + 1, 0);
  for (const Index bin : wanted) lists_below_[static_cast<std::size_t>(bin) + 1] = 1;
  std::partial_sum(lists_below_.begin(), lists_below_.end(), lists_below_.begin());

  std::size_t total = 0;
  for (std::size_t bin = 0; bin < num_bins; ++bin) {
    if (!contains(static_cast<Index>(bin))) continue;
    ranges_.push_back(bins[static_cast<Index>(bin)]);
    for (std::size_t chunk = 0; chunk < num_chunks_; ++chunk) {
      offsets_.push_back(total);
      total += votes.pairs_of_chunks[chunk * num_bins + bin];
    }
  }
  offsets_.push_back(total);
  pairs_.resize(total);
  std::atomic<bool> late = false;
  parallel::parallel_for(static_cast<Index>(num_chunks_), 1,
                         parallel::threads_for_pairs(arrays.size(), num_threads),
                         [&](Index chunk, Index) {
                           if (late || deadline.expired()) {
                             late = true;
                             return;
                           }
                           list_chunk(arrays, bins.cells(), static_cast<std::size_t>(chunk));
                         });
  if (late) *this = {};
}

void BinnedPairs::list_chunk(const geometry::CorrespondenceArrays& arrays,
                             const kernels::ScaleCells& cells, std::size_t chunk) {
  std::vector<std::size_t> next;
  for (std::size_t list = 0; list < ranges_.size(); ++list) {
    next.push_back(offsets_[list * num_chunks_ + chunk]);
  }
  std::vector<kernels::BinSpan> spans(static_cast<std::size_t>(arrays.size()));
  const Index first_row = static_cast<Index>(chunk) * kRowsPerChunk;
  for (Index row = 0; row < std::min(kRowsPerChunk, arrays.size() - first_row); ++row) {
    const Index i = first_row + row;
    kernels::scale_row(arrays, cells, i, i + 1, spans);
    for (Index j = i + 1; j < arrays.size(); ++j) {
      const kernels::BinSpan span = spans[static_cast<std::size_t>(j)];
      const std::size_t end = lists_below_[static_cast<std::size_t>(span.end())];
      for (std::size_t list = lists_below_[static_cast<std::size_t>(span.begin())]; list < end;
           ++list) {
        pairs_[next[list]++] = static_cast<std::uint32_t>(row << kColumnBits | j);
      }
    }
  }
}

bool BinnedPairs::contains(Index bin) const {
  const auto b = static_cast<std::size_t>(bin);
  return !lists_below_.empty() && lists_below_[b + 1] != lists_below_[b];
}

BitsetGraph BinnedPairs::graph(const geometry::CorrespondenceArrays& arrays, Index bin,
                               const ScaleRange& scales, int num_threads) const {
  const std::size_t list = lists_below_[static_cast<std::size_t>(bin)];
  const bool is_whole = scales.min == ranges_[list].min && scales.max == ranges_[list].max;
  const std::size_t* offsets = &offsets_[list * num_chunks_];
  const int threads = offsets[num_chunks_] - offsets[0] < kFewPairs ? 1 : num_threads;
  BitsetGraph graph(arrays.size());
  parallel::parallel_for(static_cast<Index>(num_chunks_), 1, threads, [&](Index chunk, Index) {
    const Index first_row = chunk * kRowsPerChunk;
    for (std::size_t k = offsets[chunk]; k < offsets[chunk + 1]; ++k) {
      const Index i = first_row + (pairs_[k] >> kColumnBits);
      const Index j = pairs_[k] & ((std::uint32_t{1} << kColumnBits) - 1);
      if (!is_whole && !kernels::is_consistent(arrays, i, j, scales.min, scales.max)) continue;
      graph.mutable_row(i)[static_cast<std::size_t>(j / 64)] |= std::uint64_t{1} << (j % 64);
      // the words left of the block of the diagonal are mirrored
      if (j / 64 != chunk) continue;
      graph.mutable_row(j)[static_cast<std::size_t>(i / 64)] |= std::uint64_t{1} << (i % 64);
    }
  });
  problem::mirror_upper_blocks(graph, threads);
  return graph;
}

}  // namespace gmcr::search
