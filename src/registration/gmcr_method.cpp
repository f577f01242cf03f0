#include "registration/gmcr_method.hpp"

#include <algorithm>

#include "registration/range_search.hpp"
#include "registration/scale_search.hpp"

namespace gmcr {
namespace {

constexpr Index kMaxStarts = 64;
constexpr std::uint64_t kMaxNodes = 2'000'000;

/// Search in the one consistency graph of a known scale.
Index search_known_scale(PoseSearch& search) {
  const RangeGraph range = build_range_graph(search, search.scales());
  const Index upper_bound = search_maximum_clique(search, range, kMaxNodes);
  // evidence is at most the number of inliers: where that is proven the best, so is the pose
  if (static_cast<double>(upper_bound) > search.best_evidence()) {
    grow_cliques(search, range, kMaxStarts);
  }
  return upper_bound;
}

}  // namespace

MethodResult solve_gmcr(SolveContext& context, const Objective& objective,
                        const PoseConstraints& constraints, const PairFilter& filter) {
  PoseSearch search(context, objective, constraints, filter);
  const ScaleRange& scales = constraints.scales;
  MethodResult result;
  result.upper_bound =
      scales.min == scales.max ? search_known_scale(search) : search_scales(search);
  result.upper_bound = std::max(result.upper_bound, search.max_inliers());
  if (search.best()) result.target_from_source = search.best()->target_from_source;
  return result;
}

}  // namespace gmcr
