#include "search/voted_bins.hpp"

#include <algorithm>
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

bool is_open(PoseSearch& search, const PerMeasure& bounds) {
  return exceeds(bounds.inliers, search.to_beat(Measure::Inliers)) ||
         exceeds(bounds.evidence, search.to_beat(Measure::Evidence));
}

}  // namespace

VotedBins::VotedBins(PoseSearch& search)
    : bins_(search.problem().scales(), kBinRatio, search.problem().buckets()),
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
