#include "search/best_poses.hpp"

#include <algorithm>
#include <utility>

#include "proof/tighten.hpp"
#include "search/incumbent.hpp"
#include "search/scale_modes.hpp"

namespace gmcr::search {
namespace {

constexpr Index kMaxStarts = 64;
constexpr std::uint64_t kMaxNodes = 2'000'000;
constexpr std::uint64_t kMaxWeightedNodes = 300;

/// Search in the one consistency graph of a known scale.
UpperBounds search_known_scale(PoseSearch& search) {
  const RangeGraph range = build_range_graph(search, search.scales());
  UpperBounds bounds;
  bounds.inliers = search_clique(search, range, Measure::Inliers, kMaxNodes);
  // evidence is at most the number of inliers: where that is proven the best, so is the pose
  if (bounds.inliers > search.to_beat(Measure::Evidence)) {
    explore_around_best(search, range);
    const double explored = search.to_beat(Measure::Evidence);
    grow_cliques(search, range, kMaxStarts);
    if (search.to_beat(Measure::Evidence) > explored) explore_around_best(search, range);
  }
  if (search.counts_evidence()) {
    bounds.evidence = std::min(bounds.inliers,
                               search_clique(search, range, Measure::Evidence, kMaxWeightedNodes));
    bounds.evidence = proof::tighten(search, range, Measure::Evidence, bounds.evidence,
                                     proof::certify_deadline(search, Measure::Evidence));
  }
  bounds.inliers = proof::tighten(search, range, Measure::Inliers, bounds.inliers,
                                  proof::certify_deadline(search, Measure::Inliers));
  if (!search.counts_evidence()) bounds.evidence = bounds.inliers;
  return bounds;
}

UpperBounds search_all_scales(PoseSearch& search) {
  return search.scales().min == search.scales().max ? search_known_scale(search)
                                                    : search_scales(search);
}

}  // namespace

MethodResult solve_gmcr(problem::SolveContext& context, const problem::Objective& objective,
                        const estimation::PoseConstraints& constraints,
                        const problem::PairFilter& filter) {
  PoseSearch search(context, objective, constraints, filter);
  const UpperBounds bounds = search_all_scales(search);
  search.explain(bounds);
  MethodResult result;
  result.upper_bound =
      static_cast<Index>(std::max(bounds.inliers, search.to_beat(Measure::Inliers)));
  result.evidence_upper_bound = std::max(bounds.evidence, search.to_beat(Measure::Evidence));
  std::vector<problem::Hypothesis> found;
  if (search.best()) found.push_back(*search.best());
  // a search that finds no consensus leaves nothing out for the next
  const auto may_go_on = [&] {
    return !found.empty() && found.back().num_inliers() >= problem::kMinInliers &&
           static_cast<int>(found.size()) < context.options().num_hypotheses && !context.stopped();
  };
  while (may_go_on()) {
    PoseSearch next(context, objective, constraints, filter, found);
    search_all_scales(next);
    if (!next.best()) break;
    found.push_back(*next.best());
  }
  for (const problem::Hypothesis& hypothesis : found)
    result.poses.push_back(hypothesis.target_from_source);
  return result;
}

}  // namespace gmcr::search
