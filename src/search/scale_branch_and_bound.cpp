#include "search/scale_branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proof/tighten.hpp"

namespace gmcr::search {
namespace {

constexpr double kBinRatio = 1.02;
constexpr double kMinRatio = 1.0001;  // a range as narrow as this is not halved again
constexpr Index kFew = 8;  // graphs that take no longer from all pairs than lists of pairs
constexpr std::uint64_t kMaxNodes = 20'000;  // clique search nodes a graph
constexpr std::uint64_t kMaxWeightedNodes = 1'000;
constexpr double kSimilar = 0.9;
constexpr const char* kEndedEarly =
    "a clique search ended before its proof: the upper bound may be loose";
constexpr std::size_t kMaxBytes = std::size_t{1} << 27;  // of lists of pairs, and of tables

std::size_t max_bytes(PoseSearch& search) {
  return std::min(kMaxBytes, search.context().options().memory_limit / 4);
}

ScaleVotes count_votes(PoseSearch& search, const ScaleBins& bins) {
  const problem::StageTimer timer(search.context(), "scale_votes");
  const Index n = search.arrays().size();
  const RunWeights weights =
      search.counts_evidence()
          ? RunWeights(n, bins, [&](Index i, double scale) { return search.weight(i, scale); })
          : RunWeights(n);
  return count_scale_votes(search.arrays(), bins, weights, max_bytes(search),
                           search.context().options().num_threads, search.context().deadline());
}

bool is_open(PoseSearch& search, const UpperBounds& bounds) {
  return exceeds(bounds.inliers, search.to_beat(Measure::Inliers)) ||
         exceeds(bounds.evidence, search.to_beat(Measure::Evidence));
}

double& of(UpperBounds& bounds, Measure measure) {
  return measure == Measure::Inliers ? bounds.inliers : bounds.evidence;
}

double of(const UpperBounds& bounds, Measure measure) {
  return measure == Measure::Inliers ? bounds.inliers : bounds.evidence;
}

/// Whether all pairs of the correspondences agree at one scale of the range.
bool agree_at_one_scale(const kernels::CorrespondenceArrays& arrays,
                        const std::vector<Index>& indices, ScaleRange scales) {
  for (const Index i : indices) {
    for (const Index j : indices) {
      if (j == i) break;
      const double source = (arrays.source.row(j) - arrays.source.row(i)).norm();
      const double target = (arrays.target.row(j) - arrays.target.row(i)).norm();
      const double bound = arrays.bounds[i] + arrays.bounds[j];
      if (source > 0) {
        scales.min = std::max(scales.min, (target - bound) / source);
        scales.max = std::min(scales.max, (target + bound) / source);
      }
      if (scales.min > scales.max) return false;
    }
  }
  return true;
}

}  // namespace

VotedBins::VotedBins(PoseSearch& search)
    : bins_(search.scales(), kBinRatio, search.octaves()),
      votes_(count_votes(search, bins_)),
      num_pairs_(search.arrays().size() * (search.arrays().size() - 1) / 2) {}

RangeGraph VotedBins::graph(PoseSearch& search, Index bin, const ScaleRange& scales) {
  // the first graphs mostly lead to a pose that closes most bins, so pairs are listed later
  if (is_listable(bin) && !pairs_.contains(bin) && ++num_unlisted_ > kFew) list_pairs(search, bin);
  if (!pairs_.contains(bin)) return build_range_graph(search, scales);
  return build_range_graph(search, scales, [&] {
    return pairs_.graph(search.arrays(), bin, scales, search.context().options().num_threads);
  });
}

bool VotedBins::is_listable(Index bin) const {
  constexpr Index kLeastGain = 16;  // a graph from so many more pairs takes longer than from a list
  return kLeastGain * votes_.pairs[static_cast<std::size_t>(bin)] <= num_pairs_;
}

void VotedBins::list_pairs(PoseSearch& search, Index first_bin) {
  const problem::StageTimer timer(search.context(), "graph");
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
  pairs_ = BinnedPairs(search.arrays(), bins_, votes_, wanted,
                       search.context().options().num_threads, search.context().deadline());
}

ScaleRanges::ScaleRanges(PoseSearch& search, VotedBins& voted) : search_(search), voted_(voted) {
  for (Index bin = 0; bin < voted.bins().size(); ++bin) {
    ranges_.push_back({voted.bins()[bin], bin, voted.bounds(bin)});
  }
}

double ScaleRanges::lower(Measure measure, bool jointly) {
  const parallel::Deadline deadline =
      jointly ? proof::certify_deadline(search_, measure) : parallel::Deadline(0);
  const auto is_less = [&](const Range& a, const Range& b) {
    const double bound_a = of(a.bounds, measure), bound_b = of(b.bounds, measure);
    return bound_a != bound_b ? bound_a < bound_b : a.scales.min > b.scales.min;
  };
  // as good as one scale: pairwise bounds tell no more
  const auto is_narrow = [](const ScaleRange& s) { return s.max / s.min < kMinRatio; };
  const auto is_at_floor = [&](const Range& r) {
    return of(r.floors, measure) >= of(r.bounds, measure);
  };
  const Index max_graphs = 2 * voted_.bins().size();
  std::make_heap(ranges_.begin(), ranges_.end(), is_less);
  for (Index num_graphs = 0;
       exceeds(of(ranges_.front().bounds, measure), search_.to_beat(measure));) {
    if (num_graphs == max_graphs) {
      search_.note_early_end(
          measure, {Limit::ScaleSearch, "the search over the scale ended before its proof"});
      break;
    }
    if (search_.context().stopped()) break;
    const bool done = is_done(ranges_.front(), measure, jointly);
    if (done && (is_narrow(ranges_.front().scales) || (!jointly && is_at_floor(ranges_.front())))) {
      break;
    }
    std::pop_heap(ranges_.begin(), ranges_.end(), is_less);
    Range& range = ranges_.back();
    if (done) {
      const ScaleRange scales = range.scales;
      // two halves of equal ratio, with the bounds of the whole
      const double middle = std::sqrt(scales.min) * std::sqrt(scales.max);
      const Range upper{{middle, scales.max}, range.bin, range.bounds};
      range = {{scales.min, middle}, range.bin, range.bounds};
      std::push_heap(ranges_.begin(), ranges_.end(), is_less);
      ranges_.push_back(upper);
    } else {
      search_range(range, measure, jointly ? &deadline : nullptr);
      search_.context().report("scale_search",
                               static_cast<double>(++num_graphs) / static_cast<double>(max_graphs));
    }
    std::push_heap(ranges_.begin(), ranges_.end(), is_less);
  }
  return std::max(of(ranges_.front().bounds, measure), search_.to_beat(measure));
}

bool ScaleRanges::is_done(const Range& range, Measure measure, bool jointly) const {
  const auto m = static_cast<std::size_t>(measure);
  return range.searched[m] && (!jointly || range.tightened[m]);
}

void ScaleRanges::search_range(Range& range, Measure measure, const parallel::Deadline* deadline) {
  const RangeGraph graph = voted_.graph(search_, range.bin, range.scales);
  const bool is_bin = range.scales.min == voted_.bins()[range.bin].min &&
                      range.scales.max == voted_.bins()[range.bin].max;
  // the number of inliers bounds the evidence, well where these are nearly the same
  const bool bounds_well =
      search_.to_beat(Measure::Evidence) > kSimilar * search_.to_beat(Measure::Inliers);
  if (measure == Measure::Inliers || is_bin || bounds_well) search_inliers(range, graph);
  if (measure == Measure::Evidence) search_evidence(range, graph);
  if (deadline == nullptr) return;
  double& bound = of(range.bounds, measure);
  bound = proof::tighten(search_, graph, measure, bound, *deadline);
  range.tightened[static_cast<std::size_t>(measure)] = true;
}

void ScaleRanges::search_inliers(Range& range, const RangeGraph& graph) {
  bool& searched = range.searched[static_cast<std::size_t>(Measure::Inliers)];
  const double to_beat = search_.to_beat(Measure::Inliers);
  if (!std::exchange(searched, true) && exceeds(range.bounds.inliers, to_beat)) {
    const auto [clique, upper_bound, proven] = [&] {
      const problem::StageTimer timer(search_.context(), "clique");
      return search_.context().max_clique(graph.graph, static_cast<Index>(to_beat), kMaxNodes);
    }();
    if (!clique.empty()) search_.offer(clique);
    if (!proven) search_.note_early_end(Measure::Inliers, {Limit::CliqueSearch, kEndedEarly});
    range.bounds.inliers =
        std::min(range.bounds.inliers, proven && clique.empty() ? to_beat : upper_bound);
    if (agree_at_one_scale(search_.arrays(), clique, range.scales)) {
      range.floors = {static_cast<double>(clique.size()), 0};
      for (const Index i : clique) range.floors.evidence += search_.weight(i, range.scales.min);
    }
  }
  // evidence is at most the number of inliers
  range.bounds.evidence = std::min(range.bounds.evidence, range.bounds.inliers);
}

void ScaleRanges::search_evidence(Range& range, const RangeGraph& graph) {
  bool& searched = range.searched[static_cast<std::size_t>(Measure::Evidence)];
  double& bound = range.bounds.evidence;
  if (!std::exchange(searched, true) && exceeds(bound, search_.to_beat(Measure::Evidence))) {
    bound = std::min(bound, search_clique(search_, graph, Measure::Evidence, kMaxWeightedNodes));
  }
}

}  // namespace gmcr::search
