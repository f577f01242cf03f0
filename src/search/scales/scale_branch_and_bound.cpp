#include "search/scales/scale_branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gmcr::search {
namespace {

constexpr double kMinRatio = 1.0001;         // a range as narrow as this is not halved again
constexpr std::uint64_t kMaxNodes = 20'000;  // clique search nodes a graph
constexpr std::uint64_t kMaxWeightedNodes = 1'000;
constexpr double kSimilar = 0.9;
constexpr const char* kEndedEarly =
    "a clique search ended before its proof: the upper bound may be loose";

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
    ranges_.push_back({voted.bins()[bin], bin, voted.bounds(bin)});
  }
}

double ScaleBranchAndBound::lower_upper_bound(Measure measure, const Tighten& tighten) {
  const auto is_less = [&](const Range& a, const Range& b) {
    const double bound_a = a.bounds.of(measure), bound_b = b.bounds.of(measure);
    return bound_a != bound_b ? bound_a < bound_b : a.scales.min > b.scales.min;
  };
  // as good as one scale: pairwise bounds tell no more
  const auto is_narrow = [](const ScaleRange& s) { return s.max / s.min < kMinRatio; };
  const Index max_graphs = 2 * voted_.bins().size();
  Index num_open = 0;
  bool is_over = false;
  std::make_heap(ranges_.begin(), ranges_.end(), is_less);
  for (Index num_graphs = 0;
       exceeds(ranges_.front().bounds.of(measure), search_.to_beat(measure));) {
    if (is_over) break;
    if (num_graphs == max_graphs || num_open == max_open(search_)) {
      search_.note_early_end(
          measure, {Limit::ScaleSearch, "the search over the scale ended before its proof"});
      break;
    }
    if (search_.run().stopped()) break;
    const bool done = is_done(ranges_.front(), measure, tighten != nullptr);
    if (done && (is_narrow(ranges_.front().scales) || (!tighten && is_at_floor(ranges_.front(), measure)))) {
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
      is_over = !search_range(range, measure, tighten);
      num_open += exceeds(range.bounds.of(measure), search_.to_beat(measure));
      search_.run().report("scale_search",
                           static_cast<double>(++num_graphs) / static_cast<double>(max_graphs));
    }
    std::push_heap(ranges_.begin(), ranges_.end(), is_less);
  }
  // L5: the ranges cover all scales, so the largest of their bounds is one for all
  return std::max(ranges_.front().bounds.of(measure), search_.to_beat(measure));
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

bool ScaleBranchAndBound::search_range(Range& range, Measure measure, const Tighten& tighten) {
  const RangeGraph graph = voted_.graph(search_, range.bin, range.scales);
  const bool is_bin = range.scales.min == voted_.bins()[range.bin].min &&
                      range.scales.max == voted_.bins()[range.bin].max;
  // the number of inliers bounds the evidence, well where these are nearly the same
  const bool bounds_well =
      search_.to_beat(Measure::Evidence) > kSimilar * search_.to_beat(Measure::Inliers);
  if (measure == Measure::Inliers || is_bin || bounds_well) search_inliers(range, graph);
  if (measure == Measure::Evidence) search_evidence(range, graph);
  if (!tighten) return true;
  double& bound = range.bounds.of(measure);
  const std::optional<double> tighter = tighten(graph, measure, bound);
  if (!tighter) return false;
  bound = *tighter;
  range.tightened[static_cast<std::size_t>(measure)] = true;
  return true;
}

void ScaleBranchAndBound::search_inliers(Range& range, const RangeGraph& graph) {
  bool& searched = range.searched[static_cast<std::size_t>(Measure::Inliers)];
  const double to_beat = search_.to_beat(Measure::Inliers);
  if (!std::exchange(searched, true) && exceeds(range.bounds.inliers, to_beat)) {
    auto [clique, upper_bound, proven] = [&] {
      const StageTimer timer(search_.run(), "clique");
      return search_.run().max_clique(graph.graph, static_cast<Index>(to_beat), kMaxNodes);
    }();
    if (!clique.empty()) search_.try_clique(clique);
    if (!proven) search_.note_early_end(Measure::Inliers, {Limit::CliqueSearch, kEndedEarly});
    range.bounds.inliers =
        std::min(range.bounds.inliers, proven && clique.empty() ? to_beat : upper_bound);
    range.clique = std::move(clique);
  }
  // evidence is at most the number of inliers
  range.bounds.evidence = std::min(range.bounds.evidence, range.bounds.inliers);
}

void ScaleBranchAndBound::search_evidence(Range& range, const RangeGraph& graph) {
  bool& searched = range.searched[static_cast<std::size_t>(Measure::Evidence)];
  double& bound = range.bounds.evidence;
  if (!std::exchange(searched, true) && exceeds(bound, search_.to_beat(Measure::Evidence))) {
    bound = std::min(bound, search_clique(search_, graph, Measure::Evidence, kMaxWeightedNodes));
  }
}

}  // namespace gmcr::search
