#include "search/scales/scale_votes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <list>
#include <mutex>

#include "parallel/parallel_for.hpp"
#include "search/scales/vote_tally.hpp"

namespace gmcr::search {
namespace {

// a pair's share of a sum over pairs: 1 above, the weight of its other end below this bit; for up
// to 2^22 correspondences
constexpr int kCountBit = 42;
constexpr std::uint64_t kOnePair = std::uint64_t{1} << kCountBit;

/// Tallies for as many threads as work at a time.
class TallyPool {
 public:
  TallyPool(Index num_bins, bool weighted) : num_bins_(num_bins), weighted_(weighted) {}

  VoteTally& take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return tallies_.emplace_back(num_bins_, weighted_);
    VoteTally* tally = free_.back();
    free_.pop_back();
    return *tally;
  }
  void give_back(VoteTally& tally) {
    const std::lock_guard lock(mutex_);
    free_.push_back(&tally);
  }
  const VoteTally& sum() {
    VoteTally& first = take();
    for (const VoteTally& tally : tallies_) {
      if (&tally != &first) first.add(tally);
    }
    return first;
  }

 private:
  Index num_bins_;
  bool weighted_;
  std::mutex mutex_;
  std::list<VoteTally> tallies_;
  std::vector<VoteTally*> free_;
};

/// Votes of the correspondences one after the other.
class RowVotes {
 public:
  RowVotes(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
           const BinGroupWeights& weights)
      : arrays_(arrays),
        num_bins_(bins.size()),
        cells_(bins.cells()),
        weights_(weights),
        spans_(static_cast<std::size_t>(arrays.size())),
        changes_(static_cast<std::size_t>(bins.size()) + 1),
        changes_before_(changes_) {}

  /// @param pairs_of_chunk  one a bin; those with later correspondences are added.
  void add(Index i, VoteTally& tally, std::uint32_t* pairs_of_chunk) {
    kernels::scale_row(arrays_, cells_, i, 0, spans_);
    std::fill(changes_.begin(), changes_.end(), 0);
    add_pairs(0, i);
    changes_before_ = changes_;
    add_pairs(i + 1, arrays_.size());
    std::uint64_t sum = 0, before = 0;
    for (Index group = 0, bin = 0; bin < num_bins_; ++group) {
      const std::uint64_t own = weights_.group(group)[i];
      for (const Index end = std::min(num_bins_, weights_.first_of_group(group + 1)); bin < end;
           ++bin) {
        sum += changes_[static_cast<std::size_t>(bin)];
        before += changes_before_[static_cast<std::size_t>(bin)];
        tally.add(bin, sum >> kCountBit, sum % kOnePair, own);
        pairs_of_chunk[bin] += static_cast<std::uint32_t>((sum - before) >> kCountBit);
      }
    }
  }

 private:
  /// Votes start at the first bin of an interval and end after its last one.
  void add_pairs(Index begin, Index end) {
    std::uint64_t* changes = changes_.data();
    if (weights_.all_one()) {
      for (Index j = begin; j < end; ++j) {
        const kernels::BinSpan span = spans_[static_cast<std::size_t>(j)];
        changes[span.begin()] += kOnePair;
        changes[span.end()] -= kOnePair;
      }
      return;
    }
    for (Index j = begin; j < end; ++j) {
      const kernels::BinSpan span = spans_[static_cast<std::size_t>(j)];
      const Index last = span.end() - (span.end() != span.begin());
      Index group = weights_.group_of(span.begin());
      const Index last_run = weights_.group_of(last);
      std::uint64_t share = kOnePair + weights_.group(group)[j];
      changes[span.begin()] += share;
      while (group != last_run) {
        ++group;
        const std::uint64_t next_share = kOnePair + weights_.group(group)[j];
        changes[weights_.first_of_group(group)] += next_share - share;
        share = next_share;
      }
      changes[span.end()] -= share;
    }
  }

  const geometry::CorrespondenceArrays& arrays_;
  Index num_bins_;
  kernels::ScaleCells cells_;
  const BinGroupWeights& weights_;
  std::vector<kernels::BinSpan> spans_;
  std::vector<std::uint64_t> changes_, changes_before_;
};

}  // namespace

BinGroupWeights::BinGroupWeights(Index num_correspondences)
    : num_correspondences_(num_correspondences),
      weights_(static_cast<std::size_t>(num_correspondences), kOne) {}

BinGroupWeights::BinGroupWeights(Index num_correspondences, const ScaleBins& bins,
                                 const std::function<double(Index i, double scale)>& weight)
    : num_correspondences_(num_correspondences), shift_(4) {
  constexpr Index kMaxRuns = 32;
  while (group_of(bins.size() - 1) >= kMaxRuns) ++shift_;
  for (Index group = 0; group <= group_of(bins.size() - 1); ++group) {
    const Index last = std::min(bins.size(), first_of_group(group + 1)) - 1;
    for (Index i = 0; i < num_correspondences; ++i) {
      weights_.push_back(static_cast<std::uint32_t>(std::ceil(weight(i, bins[last].max) * kOne)));
    }
  }
}

ScaleVotes count_scale_votes(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
                             const BinGroupWeights& weights, std::size_t max_bytes, int num_threads,
                             const parallel::Deadline& deadline) {
  constexpr Index kRowsPerChunk = ScaleVotes::kRowsPerChunk;
  const Index n = arrays.size();
  const auto num_bins = static_cast<std::size_t>(bins.size());
  const bool weighted = !weights.all_one();
  const std::size_t bytes = VoteTally::bytes_required(n, bins.size(), weighted);
  const auto that_fit = static_cast<int>(std::clamp<std::size_t>(max_bytes / bytes, 1, 1024));
  const int threads = std::min(
      parallel::resolve_num_threads(parallel::threads_for_pairs(n, num_threads)), that_fit);

  ScaleVotes votes{
      std::vector<Index>(num_bins), std::vector<double>(num_bins), std::vector<double>(num_bins),
      std::vector<double>(num_bins),
      std::vector<std::uint32_t>(static_cast<std::size_t>((n + kRowsPerChunk - 1) / kRowsPerChunk) *
                                 num_bins)};
  TallyPool pool(bins.size(), weighted);
  std::atomic<bool> late = false;
  parallel::parallel_for(n, kRowsPerChunk, threads, [&](Index begin, Index end) {
    if (late || deadline.expired()) {
      late = true;
      return;
    }
    VoteTally& tally = pool.take();
    RowVotes rows(arrays, bins, weights);
    std::uint32_t* pairs_of_chunk =
        votes.pairs_of_chunks.data() + static_cast<std::size_t>(begin / kRowsPerChunk) * num_bins;
    for (Index i = begin; i < end; ++i) rows.add(i, tally, pairs_of_chunk);
    pool.give_back(tally);
  });
  const VoteTally& sum = pool.sum();
  for (Index bin = 0; bin < bins.size(); ++bin) sum.read(bin, votes);
  if (late) {
    votes.pairs.assign(num_bins, n * (n - 1) / 2);
    votes.max_members.assign(num_bins, static_cast<double>(n));
    votes.max_evidence = votes.max_members;
    votes.pairs_of_chunks.clear();
  }
  return votes;
}

}  // namespace gmcr::search
