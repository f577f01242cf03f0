#include "search/scales/scale_branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parallel/parallel_for.hpp"

namespace gmcr::search {
namespace {

constexpr double kMinRatio = 1.0001;         // a range as narrow as this is not halved again
constexpr std::uint64_t kMaxNodes = 20'000;  // clique search nodes a graph
constexpr std::uint64_t kMaxWeightedNodes = 1'000;
constexpr double kSimilar = 0.9;

/// Ranges whose bound may exceed what is known after their search, before the search over the scale
/// ends: any number where a proof is asked for; else some, and as many more as small graphs cost
/// little.
Index max_open(const PoseSearch& search) {
  constexpr Index kLeast = 30, kMoreWords = Index{1} << 18;
  const Index n = search.problem().size();
  return search.problem().options().certify
             ? std::numeric_limits<Index>::max()
             : kLeast + kMoreWords / (n * (n / BitsetGraph::kBitsPerWord + 1));
}

/// Ranges that are searched side by side, at most: as many as the memory takes graphs of; one after
/// the other where the caller's solver or a proof wants the threads for itself, as does the graph
/// of many correspondences.
Index max_round(const PoseSearch& search) {
  constexpr Index kMost = 8;
  const Options& options = search.problem().options();
  const Index n = search.problem().size();
  if (options.certify || options.clique_solver || n > problem::kQuickGraph) return 1;
  const std::size_t fit =
      options.memory_limit / (2 * BitsetGraph::bytes_required(n));  // and copies
  return std::clamp<Index>(static_cast<Index>(std::min<std::size_t>(fit, kMost)), 1, kMost);
}

/// Whether all pairs of the correspondences agree at one scale of the range.
bool agree_at_one_scale(const geometry::CorrespondenceArrays& arrays,
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

ScaleBranchAndBound::ScaleBranchAndBound(PoseSearch& search, VotedBins& voted)
    : search_(search), voted_(voted) {
  for (Index bin = 0; bin < voted.bins().size(); ++bin) {
    ranges_.push_back({voted.bins()[bin], bin, voted.bounds(bin), {}});
  }
}

double ScaleBranchAndBound::lower_upper_bound(Measure measure, const Tighten& tighten) {
  // as good as one scale: pairwise bounds tell no more
  const auto is_narrow = [](const ScaleRange& s) { return s.max / s.min < kMinRatio; };
  const Index max_graphs = 2 * voted_.bins().size();
  Index num_graphs = 0, num_open = 0, round_size = 1;
  bool is_over = false;
  const auto has_less = [&](const Range& a, const Range& b) { return is_less(a, b, measure); };
  std::make_heap(ranges_.begin(), ranges_.end(), has_less);
  while (!is_over && exceeds(ranges_.front().bounds.of(measure), search_.to_beat(measure))) {
    if (num_graphs == max_graphs || num_open == max_open(search_)) {
      search_.note_early_end(
          measure, {Limit::ScaleSearch, "the search over the scale ended before its proof"});
      break;
    }
    if (search_.run().stopped()) break;
    if (is_done(ranges_.front(), measure, tighten != nullptr)) {
      const Range& front = ranges_.front();
      if (is_narrow(front.scales) || (!tighten && is_at_floor(front, measure))) break;
      halve_front(measure);
      continue;
    }
    const Index most =
        std::min({round_size, max_graphs - num_graphs, max_open(search_) - num_open});
    const double to_beat = search_.to_beat(measure);
    const Round round = take_round(most, measure, tighten != nullptr);
    is_over = !search_round(round, measure, tighten);
    num_graphs += static_cast<Index>(round.size());
    num_open += std::count_if(round.begin(), round.end(), [&](const Range& range) {
      return exceeds(range.bounds.of(measure), search_.to_beat(measure));
    });
    // a pose that is better mostly closes the ranges that would come next
    round_size =
        search_.to_beat(measure) > to_beat ? 1 : std::min(2 * round_size, max_round(search_));
    search_.run().report("scale_search",
                         static_cast<double>(num_graphs) / static_cast<double>(max_graphs));
    for (auto end = ranges_.end() - std::ssize(round); end != ranges_.end();) {
      std::push_heap(ranges_.begin(), ++end, has_less);
    }
  }
  // L5: the ranges cover all scales, so the largest of their bounds is one for all
  return std::max(ranges_.front().bounds.of(measure), search_.to_beat(measure));
}

bool ScaleBranchAndBound::is_less(const Range& a, const Range& b, Measure measure) {
  const double bound_a = a.bounds.of(measure), bound_b = b.bounds.of(measure);
  return bound_a != bound_b ? bound_a < bound_b : a.scales.min > b.scales.min;
}

/// Into two halves of equal ratio, with the bounds of the whole.
void ScaleBranchAndBound::halve_front(Measure measure) {
  const auto has_less = [&](const Range& a, const Range& b) { return is_less(a, b, measure); };
  std::pop_heap(ranges_.begin(), ranges_.end(), has_less);
  Range& whole = ranges_.back();
  const ScaleRange scales = whole.scales;
  const double middle = std::sqrt(scales.min) * std::sqrt(scales.max);
  const Range upper{{middle, scales.max}, whole.bin, whole.bounds, {}};
  whole = {{scales.min, middle}, whole.bin, whole.bounds, {}};
  std::push_heap(ranges_.begin(), ranges_.end(), has_less);
  ranges_.push_back(upper);
  std::push_heap(ranges_.begin(), ranges_.end(), has_less);
}

ScaleBranchAndBound::Round ScaleBranchAndBound::take_round(Index most, Measure measure,
                                                           bool with_tightening) {
  auto begin = ranges_.end();
  const auto is_wanted = [&] {
    return begin != ranges_.begin() && ranges_.end() - begin < most &&
           !is_done(ranges_.front(), measure, with_tightening) &&
           exceeds(ranges_.front().bounds.of(measure), search_.to_beat(measure));
  };
  while (is_wanted()) {
    std::pop_heap(ranges_.begin(), begin--,
                  [&](const Range& a, const Range& b) { return is_less(a, b, measure); });
  }
  return {begin, ranges_.end()};
}

bool ScaleBranchAndBound::is_done(const Range& range, Measure measure, bool with_tightening) const {
  const auto m = static_cast<std::size_t>(measure);
  return range.searched[m] && (!with_tightening || range.tightened[m]);
}

/// Whether no halving lowers the bound. L2: where all pairs of a clique share a scale, no part of
/// the range around it has a smaller one.
bool ScaleBranchAndBound::is_at_floor(const Range& range, Measure measure) const {
  const problem::Objective& objective = search_.problem().objective();
  const double floor = measure == Measure::Inliers
                           ? static_cast<double>(range.clique.size())
                           : objective.evidence_of(range.clique, range.scales.min);
  return floor >= range.bounds.of(measure) &&
         agree_at_one_scale(search_.problem().arrays(), range.clique, range.scales);
}

bool ScaleBranchAndBound::search_round(Round round, Measure measure, const Tighten& tighten) {
  std::vector<RangeGraph> graphs;
  for (const Range& range : round) {
    graphs.push_back(voted_.graph(search_, range.bin, range.scales));
  }
  std::vector<Cliques> found(round.size());
  {
    const StageTimer timer(search_.run(), "clique");
    const int num_threads = search_.run().options().num_threads;
    parallel::parallel_for(std::ssize(round), 1, num_threads, [&](Index i, Index) {
      const auto k = static_cast<std::size_t>(i);
      found[k] = find_cliques(round[k], graphs[k], measure, round.size() > 1 ? 1 : num_threads);
    });
  }
  for (std::size_t k = 0; k < round.size(); ++k) {
    take_cliques(round[k], measure, std::move(found[k]));
    if (!tighten) continue;
    double& bound = round[k].bounds.of(measure);
    const std::optional<double> tighter = tighten(graphs[k], measure, bound);
    if (!tighter) return false;
    bound = *tighter;
    round[k].tightened[static_cast<std::size_t>(measure)] = true;
  }
  return true;
}

ScaleBranchAndBound::Cliques ScaleBranchAndBound::find_cliques(const Range& range,
                                                               const RangeGraph& graph,
                                                               Measure measure,
                                                               int num_threads) const {
  Cliques found{asks_for_inliers(range, measure), {}, {}};
  const auto is_wanted = [&](Measure m, double bound) {
    return !range.searched[static_cast<std::size_t>(m)] && exceeds(bound, search_.to_beat(m));
  };
  double bound = range.bounds.of(measure);
  if (found.asks_for_inliers && is_wanted(Measure::Inliers, range.bounds.inliers)) {
    found.inliers = find_clique(search_, graph, Measure::Inliers, kMaxNodes, num_threads);
    bound = std::min(bound, found.inliers->upper_bound);
  }
  if (measure == Measure::Evidence && is_wanted(Measure::Evidence, bound)) {
    found.evidence = find_clique(search_, graph, Measure::Evidence, kMaxWeightedNodes, num_threads);
  }
  return found;
}

/// Whether the number of inliers is searched: for itself, and where it bounds the evidence well,
/// as these are nearly the same.
bool ScaleBranchAndBound::asks_for_inliers(const Range& range, Measure measure) const {
  const ScaleRange bin = voted_.bins()[range.bin];
  const bool is_bin = range.scales.min == bin.min && range.scales.max == bin.max;
  return measure == Measure::Inliers || is_bin ||
         search_.to_beat(Measure::Evidence) > kSimilar * search_.to_beat(Measure::Inliers);
}

void ScaleBranchAndBound::take_cliques(Range& range, Measure measure, Cliques found) {
  const auto take = [&](Measure m, const std::optional<problem::Run::Clique>& clique) {
    range.searched[static_cast<std::size_t>(m)] = true;
    double& bound = range.bounds.of(m);
    if (clique) bound = std::min(bound, take_clique(search_, m, *clique));
  };
  if (found.asks_for_inliers) {
    take(Measure::Inliers, found.inliers);
    // evidence is at most the number of inliers
    range.bounds.evidence = std::min(range.bounds.evidence, range.bounds.inliers);
    if (found.inliers) range.clique = std::move(found.inliers->vertices);
  }
  if (measure == Measure::Evidence) take(Measure::Evidence, found.evidence);
}

}  // namespace gmcr::search
