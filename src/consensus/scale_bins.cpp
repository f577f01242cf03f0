#include "consensus/scale_bins.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

/// Difference arrays: votes start at the first bin of an interval and end after its last one.
struct VoteChanges {
  std::vector<Index> pairs;
  std::vector<double> evidence;
};

}  // namespace

ScaleBins::ScaleBins(const ScaleRange& range, double ratio) : first_cell_(cell(range.min)) {
  const double log_min = std::log(range.min), log_ratio = std::log(ratio);
  const double count = std::ceil((std::log(range.max) - log_min) / log_ratio - 1e-9);
  edges_.push_back(range.min);
  for (double b = 1; b < count; ++b) {
    const double next = std::exp(log_min + b * log_ratio);
    if (next > edges_.back() && next < range.max) edges_.push_back(next);
  }
  edges_.push_back(range.max);
  std::int32_t bin = 0;
  for (std::uint64_t c = first_cell_; c <= cell(range.max); ++c) {
    const double lower = std::bit_cast<double>(c << kCellShift);
    while (bin + 1 < size() && edge(bin + 1) <= lower) ++bin;
    bin_of_cell_.push_back(bin);
  }
}

ScaleVotes count_scale_votes(const kernels::CorrespondenceArrays& arrays, const ScaleBins& bins,
                             const std::function<double(Index i, Index run)>& weight,
                             int num_threads, const Deadline& deadline) {
  constexpr Index kRowsPerChunk = 64;
  const Index n = arrays.size();
  const auto num_bins = static_cast<std::size_t>(bins.size());
  std::vector<VoteChanges> chunks(
      static_cast<std::size_t>((n + kRowsPerChunk - 1) / kRowsPerChunk));
  std::atomic<bool> late = false;
  parallel_for(n, kRowsPerChunk, num_threads, [&](Index begin, Index end) {
    if (late || deadline.expired()) {
      late = true;
      return;
    }
    VoteChanges changes{std::vector<Index>(num_bins + 1), std::vector<double>(num_bins + 1)};
    for_each_voting_pair(arrays, bins, begin, end, [&](Index i, Index j, Index first, Index last) {
      ++changes.pairs[static_cast<std::size_t>(first)];
      --changes.pairs[static_cast<std::size_t>(last) + 1];
      for (Index begin_of_run = first; begin_of_run <= last;) {
        const Index run = bins.run_of(begin_of_run);
        const Index end_of_run = std::min(last, bins.last_of_run(run)) + 1;
        const double evidence = weight(i, run) * weight(j, run);
        changes.evidence[static_cast<std::size_t>(begin_of_run)] += evidence;
        changes.evidence[static_cast<std::size_t>(end_of_run)] -= evidence;
        begin_of_run = end_of_run;
      }
    });
    chunks[static_cast<std::size_t>(begin / kRowsPerChunk)] = std::move(changes);
  });

  if (late) {
    const Index all = n * (n - 1) / 2;
    return {std::vector<Index>(num_bins, all),
            std::vector<double>(num_bins, static_cast<double>(all))};
  }
  ScaleVotes votes{std::vector<Index>(num_bins), std::vector<double>(num_bins)};
  Index pairs = 0;
  double evidence = 0;
  for (std::size_t bin = 0; bin < num_bins; ++bin) {
    for (const VoteChanges& chunk : chunks) {
      pairs += chunk.pairs[bin];
      evidence += chunk.evidence[bin];
    }
    votes.pairs[bin] = pairs;
    votes.evidence[bin] = evidence;
  }
  return votes;
}

}  // namespace gmcr
