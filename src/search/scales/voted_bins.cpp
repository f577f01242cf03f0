#include "search/scales/voted_bins.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gmcr::search {
namespace {

constexpr double kBinRatio = 1.02;
constexpr Index kFew = 8;  // graphs that take no longer from all pairs than lists of pairs
constexpr std::size_t kMaxBytes = std::size_t{1} << 27;  // of lists of pairs, and of tables

std::size_t max_bytes(PoseSearch& search) {
  return std::min(kMaxBytes, search.run().options().memory_limit / 4);
}

ScaleVotes count_votes(PoseSearch& search, const ScaleBins& bins) {
  const StageTimer timer(search.run(), "scale_votes");
  const Index n = search.problem().arrays().size();
  const BinGroupWeights weights =
      search.problem().objective().is_weighted()
          ? BinGroupWeights(n, bins,
                            [&](Index i, double scale) {
                              return search.problem().objective().weight(i, scale);
                            })
          : BinGroupWeights(n);
  return count_scale_votes(search.problem().arrays(), bins, weights, max_bytes(search),
                           search.run().options().num_threads, search.run().deadline());
}

/// Number of pairs that agree at some scale of each bin.
std::vector<Index> count_pairs(const geometry::CorrespondenceArrays& arrays,
                               const ScaleBins& bins) {
  std::vector<Index> pairs(static_cast<std::size_t>(bins.size()) + 1, 0);
  std::vector<kernels::BinSpan> spans(static_cast<std::size_t>(arrays.size()));
  for (Index i = 0; i + 1 < arrays.size(); ++i) {
    kernels::scale_row(arrays, bins.cells(), i, i + 1, spans);
    for (Index j = i + 1; j < arrays.size(); ++j) {
      const kernels::BinSpan span = spans[static_cast<std::size_t>(j)];
      ++pairs[static_cast<std::size_t>(span.begin())];
      --pairs[static_cast<std::size_t>(span.end())];
    }
  }
  std::partial_sum(pairs.begin(), pairs.end(), pairs.begin());
  pairs.pop_back();
  return pairs;
}

/// The scales at which enough pairs agree for more than the best pose so far (L5 (c)), from the
/// first to the last; of a few correspondences, as it takes a pass over all pairs.
ScaleRange open_scales(PoseSearch& search) {
  constexpr Index kFewCorrespondences = 256;
  const ScaleRange& all = search.problem().scales();
  if (!search.best() || search.problem().size() > kFewCorrespondences) return all;
  const StageTimer timer(search.run(), "scale_votes");
  const ScaleBins bins(all, kBinRatio, search.problem().buckets());
  const std::vector<Index> pairs = count_pairs(search.problem().arrays(), bins);
  // evidence is at most the number of members
  const double members = std::floor(search.to_beat(Measure::Evidence)) + 1;
  ScaleRange open{0, 0};
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const auto num_pairs = static_cast<double>(pairs[static_cast<std::size_t>(bin)]);
    if (num_pairs < members * (members - 1) / 2) continue;
    if (open.max == 0) open.min = bins[bin].min;
    open.max = bins[bin].max;
  }
  if (open.max > 0) return open;
  const double scale = search.best()->pose.scale();  // of one bin: no scale is open
  return {std::max(all.min, scale / kBinRatio), std::min(all.max, scale * kBinRatio)};
}

bool is_open(PoseSearch& search, const PerMeasure& bounds) {
  return exceeds(bounds.inliers, search.to_beat(Measure::Inliers)) ||
         exceeds(bounds.evidence, search.to_beat(Measure::Evidence));
}

}  // namespace

VotedBins::VotedBins(PoseSearch& search)
    : bins_(open_scales(search), kBinRatio, search.problem().buckets()),
      votes_(count_votes(search, bins_)),
      num_pairs_(search.problem().arrays().size() * (search.problem().arrays().size() - 1) / 2) {}

RangeGraph VotedBins::graph(PoseSearch& search, Index bin, const ScaleRange& scales) {
  // the first graphs mostly lead to a pose that closes most bins, so pairs are listed later
  if (is_listable(bin) && !pairs_.contains(bin) && ++num_unlisted_ > kFew) list_pairs(search, bin);
  if (!pairs_.contains(bin)) return build_range_graph(search, scales);
  return build_range_graph(search, scales, [&] {
    return pairs_.graph(search.problem().arrays(), bin, scales, search.run().options().num_threads);
  });
}

bool VotedBins::is_listable(Index bin) const {
  constexpr Index kLeastGain = 16;  // a graph from so many more pairs takes longer than from a list
  return kLeastGain * votes_.pairs[static_cast<std::size_t>(bin)] <= num_pairs_;
}

void VotedBins::list_pairs(PoseSearch& search, Index first_bin) {
  const StageTimer timer(search.run(), "graph");
  std::vector<Index> wanted{first_bin};
  for (Index bin = 0; bin < bins_.size(); ++bin) {
    if (bin != first_bin && is_listable(bin) && is_open(search, bounds(bin))) wanted.push_back(bin);
  }
  std::stable_sort(wanted.begin() + 1, wanted.end(),
                   [&](Index a, Index b) { return bounds(a).evidence > bounds(b).evidence; });
  wanted.resize(BinnedPairs::num_that_fit(votes_, wanted, max_bytes(search)));
  if (static_cast<Index>(wanted.size()) < kFew) return;
  // lists cost as much as some graphs from all pairs: so many are built before, lest lists that are
  // hardly used are made again and again
  Index num_listed = 0;
  for (const Index bin : wanted) num_listed += votes_.pairs[static_cast<std::size_t>(bin)];
  if (num_unlisted_ < kFew * (1 + num_listed / std::max<Index>(1, num_pairs_))) return;
  num_unlisted_ = 0;
  pairs_ = {};  // frees what is no longer asked for
  pairs_ = BinnedPairs(search.problem().arrays(), bins_, votes_, wanted,
                       search.run().options().num_threads, search.run().deadline());
}

}  // namespace gmcr::search
