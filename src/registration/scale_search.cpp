#include "registration/scale_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include "consensus/binned_pairs.hpp"
#include "consensus/scale_bins.hpp"
#include "registration/certificate.hpp"
#include "registration/tighten.hpp"

namespace gmcr {
namespace {

constexpr double kBinRatio = 1.02;
constexpr double kMinRatio = 1.0001;  // a bin as narrow as this is not halved again
constexpr double kSizeFactor = 20;
constexpr Index kMaxModes = 40;
constexpr Index kMaxStarts = 64;
constexpr std::uint64_t kMaxNodes = 20'000;  // clique search nodes a graph
constexpr std::uint64_t kMaxWeightedNodes = 1'000;

constexpr std::size_t kMaxListBytes = std::size_t{1} << 28;  // of the pairs of each bin
constexpr Index kNoBin = -1;

/// A range of scales and the most that a pose in it can have.
struct BoundedRange {
  ScaleRange scales;
  double bound = 0;
  Index bin = kNoBin;  ///< the bin that the range is, if it is one
  bool searched = false;

  bool operator<(const BoundedRange& other) const {
    if (bound != other.bound) return bound < other.bound;
    return scales.min > other.scales.min;
  }
};

/// The bins and what the pairs say of them.
struct VotedBins {
  ScaleBins bins;
  ScaleVotes votes;
  std::optional<BinnedPairs> pairs;  ///< where they fit into memory

  RangeGraph graph(PoseSearch& search, Index bin) const {
    if (!pairs) return build_range_graph(search, bins[bin]);
    return build_range_graph(search, bins[bin], [&] { return pairs->graph(bin); });
  }
};

ScaleVotes vote(PoseSearch& search, const ScaleBins& bins) {
  // weights grow with the scale: those at the end of a run of bins bound the others
  const Index n = search.arrays().size(), num_runs = bins.num_runs();
  Eigen::ArrayXXd weights(num_runs, n);
  for (Index i = 0; i < n; ++i) {
    for (Index run = 0; run < num_runs; ++run) {
      weights(run, i) = search.weight(i, bins[bins.last_of_run(run)].max);
    }
  }
  return count_scale_votes(
      search.arrays(), bins, [&](Index i, Index run) { return weights(run, i); },
      search.context().options().num_threads, search.context().deadline());
}

VotedBins vote(PoseSearch& search) {
  const StageTimer timer(search.context(), "scale_votes");
  const ScaleBins bins(search.scales(), kBinRatio);
  ScaleVotes votes = vote(search, bins);
  if (search.context().stopped()) return {bins, std::move(votes), std::nullopt};
  auto pairs =
      BinnedPairs::make(search.arrays(), bins, votes,
                        std::min(kMaxListBytes, search.context().options().budget.memory / 4));
  return {bins, std::move(votes), std::move(pairs)};
}

/// The two halves of a range, of equal ratio, with the bound of the whole.
std::pair<BoundedRange, BoundedRange> halves(const BoundedRange& range) {
  const double middle = std::sqrt(range.scales.min * range.scales.max);
  return {{{range.scales.min, middle}, range.bound}, {{middle, range.scales.max}, range.bound}};
}

/// Most that a pose at a scale of the bin can have, by the pairs that vote for it.
double bound_of_votes(const VotedBins& voted, Measure measure, Index bin) {
  const auto b = static_cast<std::size_t>(bin);
  const auto members = static_cast<double>(max_members(voted.votes.pairs[b]));
  if (measure == Measure::Inliers) return members;
  // W^2 less the sum of the squared weights, at most W, is twice what the pairs of the set vote
  const double evidence = (1 + std::sqrt(1 + 8 * voted.votes.evidence[b])) / 2;
  return std::min(members, evidence * (1 + 1e-9));
}

/// Branch and bound over the scale. @return upper bound on the measure of any pose.
/// @param deadline  of the joint searches.
double bound_scales(PoseSearch& search, const VotedBins& voted, Measure measure,
                    const Deadline& deadline) {
  std::vector<BoundedRange> ranges;
  for (Index bin = 0; bin < voted.bins.size(); ++bin) {
    ranges.push_back({voted.bins[bin], bound_of_votes(voted, measure, bin), bin});
  }
  std::priority_queue<BoundedRange> queue({}, std::move(ranges));
  const Index max_ranges = 2 * voted.bins.size();
  for (Index searched = 0; !queue.empty() && exceeds(queue.top().bound, search.to_beat(measure));) {
    BoundedRange range = queue.top();
    if (searched == max_ranges) {
      search.note_early_end(measure, "the search over the scale ended before its proof");
      return range.bound;
    }
    if (search.context().stopped()) return range.bound;
    queue.pop();
    if (range.searched) {
      // as good as one scale: pairwise bounds tell no more
      if (range.scales.max / range.scales.min < kMinRatio) return range.bound;
      const auto [lower, upper] = halves(range);
      queue.push(lower);
      queue.push(upper);
      continue;
    }
    const RangeGraph graph = range.bin == kNoBin ? build_range_graph(search, range.scales)
                                                 : voted.graph(search, range.bin);
    const std::uint64_t max_nodes = measure == Measure::Inliers ? kMaxNodes : kMaxWeightedNodes;
    range.bound = std::min(range.bound, search_clique(search, graph, measure, max_nodes));
    range.bound = tighten(search, graph, measure, range.bound, deadline);
    range.searched = true;
    queue.push(range);
    search.context().report("scale_search",
                            static_cast<double>(++searched) / static_cast<double>(max_ranges));
  }
  return search.to_beat(measure);
}

/// Lowers the bounds that leave room for a better pose, by cliques alone or jointly.
void lower(UpperBounds& bounds, PoseSearch& search, const VotedBins& voted, bool jointly) {
  const auto lower_one = [&](double& bound, Measure measure) {
    if (!exceeds(bound, search.to_beat(measure))) return;
    const Deadline deadline = jointly ? certify_deadline(search, measure) : Deadline(0);
    bound = std::min(bound, bound_scales(search, voted, measure, deadline));
  };
  if (search.counts_evidence()) lower_one(bounds.evidence, Measure::Evidence);
  lower_one(bounds.inliers, Measure::Inliers);
  if (!search.counts_evidence()) bounds.evidence = bounds.inliers;
}

/// Bins of most evidence, none of them beside a better one.
std::vector<Index> top_modes(const std::vector<double>& evidence) {
  constexpr Index kNeighbours = 2;
  const auto count = static_cast<Index>(evidence.size());
  std::vector<Index> order(evidence.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return evidence[static_cast<std::size_t>(a)] > evidence[static_cast<std::size_t>(b)];
  });
  std::vector<bool> taken(evidence.size(), false);
  std::vector<Index> modes;
  for (const Index bin : order) {
    if (static_cast<Index>(modes.size()) == kMaxModes) break;
    if (taken[static_cast<std::size_t>(bin)]) continue;
    modes.push_back(bin);
    for (Index near = std::max<Index>(0, bin - kNeighbours);
         near <= std::min(count - 1, bin + kNeighbours); ++near) {
      taken[static_cast<std::size_t>(near)] = true;
    }
  }
  return modes;
}

/// L7: candidate cliques at the scales of most evidence.
void explore_modes(PoseSearch& search, const VotedBins& voted) {
  for (const Index bin : top_modes(voted.votes.evidence)) {
    const double bound = bound_of_votes(voted, Measure::Evidence, bin);
    if (!exceeds(bound, search.to_beat(Measure::Evidence))) continue;
    if (search.best() && search.context().stopped()) return;
    grow_cliques(search, voted.graph(search, bin), kMaxStarts);
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median distance of the points from their median point.
double median_reach(const Points& points) {
  if (points.cols() == 0) return 0;
  Eigen::Vector3d centre;
  for (Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd row = points.row(axis);
    centre[axis] = median({row.begin(), row.end()});
  }
  const Eigen::RowVectorXd distances = (points.colwise() - centre).colwise().norm();
  return median({distances.begin(), distances.end()});
}

}  // namespace

ScaleRange default_scale_range(const Correspondences& correspondences) {
  // the median withstands a few points far out; the mean square sees a far minority of both clouds
  const auto ratio_of = [](double source, double target) {
    return source > 0 && target > 0 ? target / source : 1;
  };
  const double by_norm = ratio_of(correspondences.source.norm(), correspondences.target.norm());
  const double by_median =
      ratio_of(median_reach(correspondences.source), median_reach(correspondences.target));
  return {std::min(by_norm, by_median) / kSizeFactor, std::max(by_norm, by_median) * kSizeFactor};
}

UpperBounds search_scales(PoseSearch& search) {
  const VotedBins voted = vote(search);
  explore_modes(search, voted);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  UpperBounds bounds{kNone, kNone};
  // joint searches may take all of the time, so what cliques prove comes first
  lower(bounds, search, voted, false);
  if (search.certifies()) lower(bounds, search, voted, true);
  return bounds;
}

}  // namespace gmcr
