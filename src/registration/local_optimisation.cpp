#include "registration/local_optimisation.hpp"

#include <optional>
#include <utility>

#include "estimation/similarity_fit.hpp"

namespace gmcr {
namespace {

std::optional<Similarity> fit(const Objective& objective, const ScaleRange& scales,
                              const std::vector<Index>& indices) {
  const Correspondences& c = objective.correspondences();
  return fit_similarity(c.source, c.target, c.bounds, indices, scales);
}

/// Fits to the consensus set until it no longer changes.
Hypothesis to_fixed_point(const Objective& objective, const ScaleRange& scales, Hypothesis best) {
  constexpr int kMaxIterations = 20;
  std::vector<Index> indices = best.inliers;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const auto pose = fit(objective, scales, indices);
    if (!pose) break;
    Hypothesis next = objective.judge(*pose);
    const bool settled = next.inliers == indices;
    indices = next.inliers;
    if (is_better(next, best)) best = std::move(next);
    if (settled) break;
  }
  return best;
}

}  // namespace

Hypothesis optimise_locally(const Objective& objective, const ScaleRange& scales,
                            const Similarity& start) {
  Hypothesis best = objective.judge(start);
  Similarity pose = start;
  for (const double factor : {2.0, 1.5}) {
    const auto wider = fit(objective, scales, objective.within(pose, factor));
    if (!wider) return best;
    pose = *wider;
  }
  Hypothesis widened = objective.judge(pose);
  if (is_better(widened, best)) best = std::move(widened);
  return to_fixed_point(objective, scales, std::move(best));
}

}  // namespace gmcr
