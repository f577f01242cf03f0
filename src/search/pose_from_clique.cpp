#include "search/pose_from_clique.hpp"

#include <algorithm>
#include <utility>

#include "estimation/constrained_fit.hpp"
#include "paper/scale_consensus.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::search {
namespace {

constexpr std::size_t kMaxMembers = 64;
constexpr std::size_t kMaxTims = 128;
constexpr std::uint64_t kMaxCliqueNodes = 10'000;

/// The longest TIMs among up to kMaxMembers members of the clique, spread evenly over it.
paper::Tims longest_tims(const problem::Correspondences& correspondences,
                         const std::vector<Index>& clique) {
  std::vector<Index> members;
  const std::size_t count = std::min(clique.size(), kMaxMembers);
  for (std::size_t m = 0; m < count; ++m) members.push_back(clique[m * clique.size() / count]);

  std::vector<std::pair<double, paper::Pair>> by_length;
  for (const auto [p, q] : paper::all_pairs(static_cast<Index>(count))) {
    const paper::Pair pair{members[static_cast<std::size_t>(p)],
                           members[static_cast<std::size_t>(q)]};
    const double squared_length =
        (correspondences.source.col(pair.second) - correspondences.source.col(pair.first))
            .squaredNorm();
    by_length.emplace_back(squared_length, pair);
  }
  std::stable_sort(by_length.begin(), by_length.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  by_length.resize(std::min(by_length.size(), kMaxTims));
  std::vector<paper::Pair> pairs;
  pairs.reserve(by_length.size());
  for (const auto& [length, pair] : by_length) pairs.push_back(pair);
  return paper::make_tims(correspondences, std::move(pairs));
}

/// Scale (where it is not known), rotation and translation stage on the TIMs of a clique.
std::optional<Similarity> staged_pose(problem::SolveContext& context,
                                      const problem::Correspondences& correspondences,
                                      const estimation::PoseConstraints& constraints,
                                      const std::vector<Index>& clique) {
  const paper::Tims tims = longest_tims(correspondences, clique);
  Similarity pose;
  const ScaleRange& scales = constraints.scales;
  pose.scale = scales.min;
  if (scales.min < scales.max) {
    const auto scale = paper::scale_consensus(tims, scales);
    if (!scale) return std::nullopt;
    pose.scale = scale->scale;
  }
  const auto rotation = paper::rotation_consensus(context, tims, pose.scale, kMaxCliqueNodes);
  if (!rotation) return std::nullopt;
  pose.rotation = rotation->rotation;
  const paper::TranslationConsensus translation = paper::translation_consensus(
      context, correspondences, paper::touched_correspondences(tims, rotation->tims), pose.scale,
      pose.rotation, kMaxCliqueNodes);
  pose.translation = translation.translation;
  if (constraints.priors.admit_all()) return pose;
  return estimation::fit_pose(correspondences.source, correspondences.target,
                              correspondences.bounds, translation.correspondences,
                              estimation::at_scale(constraints, pose.scale));
}

/// Whether a part of the clique that beats the rival would have to be nearly all of it, while fits
/// hold less than half. On the paper's structured problems no such part was ever found.
bool needs_too_much(double in_clique, double held, double to_exceed) {
  constexpr double kMargin = 1.2, kHeld = 0.5;
  return in_clique < kMargin * to_exceed && held < kHeld * in_clique;
}

}  // namespace

std::optional<problem::Hypothesis> pose_from_clique(problem::SolveContext& context,
                                                    const problem::Objective& objective,
                                                    const estimation::PoseConstraints& constraints,
                                                    const std::vector<Index>& clique,
                                                    const refine::Rival& rival) {
  const problem::Correspondences& c = objective.correspondences();
  const auto direct = estimation::fit_pose(c.source, c.target, c.bounds, clique, constraints);
  if (!direct) return std::nullopt;
  ++context.diagnostics().num_candidates;
  std::optional<problem::Hypothesis> best =
      refine::optimise_locally(objective, constraints, *direct, rival);
  if (!best) return std::nullopt;
  const auto holds_all = [&] {
    return std::includes(best->inliers.begin(), best->inliers.end(), clique.begin(), clique.end());
  };
  if (holds_all()) return best;
  const double in_clique = objective.evidence_of(clique, best->target_from_source.scale);
  if (in_clique <= rival.evidence()) return best;
  // a clique around the best pose so far has no part worth the stages
  if (rival.is_near(best->inliers)) return best;
  best = refine::hold_all(objective, constraints, clique, std::move(*best));
  if (holds_all() || needs_too_much(in_clique, best->evidence, rival.evidence())) return best;
  const auto staged = staged_pose(context, c, constraints, clique);
  if (!staged) return best;
  ++context.diagnostics().num_candidates;
  const auto other = refine::optimise_locally(objective, constraints, *staged, rival);
  return other && problem::is_better(*other, *best) ? other : best;
}

}  // namespace gmcr::search
