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

ScaleBins::ScaleBins(const ScaleRange& range, double ratio)
    : range_(range), log_min_(std::log(range.min)), log_ratio_(std::log(ratio)) {
  count_ = std::max<Index>(
      1, static_cast<Index>(std::ceil((std::log(range.max) - log_min_) / log_ratio_ - 1e-9)));
}

ScaleRange ScaleBins::operator[](Index bin) const {
  const auto edge = [&](Index b) {
    return std::exp(log_min_ + static_cast<double>(b) * log_ratio_);
  };
  return {bin == 0 ? range_.min : edge(bin), bin + 1 == count_ ? range_.max : edge(bin + 1)};
}

std::pair<Index, Index> ScaleBins::covering(double lower, double upper) const {
  if (!(lower <= range_.max && upper >= range_.min)) return {0, -1};
  constexpr double kEdge = 1e-9;  // of a bin's width: more than the rounding of log and exp
  const double first = lower > range_.min ? (std::log(lower) - log_min_) / log_ratio_ - kEdge : 0;
  const double last = upper < range_.max ? (std::log(upper) - log_min_) / log_ratio_ + kEdge
                                         : static_cast<double>(count_);
  return {std::clamp<Index>(static_cast<Index>(first), 0, count_ - 1),
          std::clamp<Index>(static_cast<Index>(last), 0, count_ - 1)};
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
