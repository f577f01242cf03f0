#include "search/pose_from_clique.hpp"

#include <algorithm>
#include <utility>

#include "estimation/constrained_fit.hpp"
#include "paper/rotation_consensus.hpp"
#include "paper/scale_consensus.hpp"
#include "paper/translation_consensus.hpp"
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

/// The paper's scale (where it is not known), rotation and translation stage on the TIMs of a
/// clique.
std::optional<problem::CentredPose> staged_pose(const problem::Problem& problem, problem::Run& run,
                                                const std::vector<Index>& clique) {
  const problem::Correspondences& c = problem.correspondences();
  const paper::Tims tims = longest_tims(c, clique);
  Similarity pose;
  pose.scale = problem.scales().min;
  if (!problem.scale_is_known()) {
    const auto scale = paper::scale_consensus(tims, problem.scales());
    if (!scale) return std::nullopt;
    pose.scale = scale->scale;
  }
  const auto rotation = paper::rotation_consensus(run, tims, pose.scale, kMaxCliqueNodes);
  if (!rotation) return std::nullopt;
  pose.rotation = rotation->rotation;
  const paper::TranslationConsensus translation =
      paper::translation_consensus(run, c, paper::touched_correspondences(tims, rotation->tims),
                                   pose.scale, pose.rotation, kMaxCliqueNodes);
  pose.translation = translation.translation;
  if (problem.constraints().priors.admit_all()) return problem::CentredPose{pose};
  const auto fit = estimation::fit_pose(c.source, c.target, c.bounds, translation.correspondences,
                                        estimation::at_scale(problem.constraints(), pose.scale));
  if (!fit) return std::nullopt;
  return problem::CentredPose{*fit};
}

/// Whether a part of the clique that beats the incumbent would have to be nearly all of it, while
/// fits hold less than half. On the paper's structured problems no such part was ever found.
bool needs_too_much(double in_clique, double held, double to_exceed) {
  constexpr double kMargin = 1.2, kHeld = 0.5;
  return in_clique < kMargin * to_exceed && held < kHeld * in_clique;
}

}  // namespace

std::optional<problem::Hypothesis> pose_from_clique(const problem::Problem& problem,
                                                    problem::Run& run,
                                                    const std::vector<Index>& clique,
                                                    const refine::Incumbent& incumbent) {
  const problem::Correspondences& c = problem.correspondences();
  const auto direct =
      estimation::fit_pose(c.source, c.target, c.bounds, clique, problem.constraints());
  if (!direct) return std::nullopt;
  ++run.diagnostics().num_candidates;
  std::optional<problem::Hypothesis> best = refine::optimise_locally(problem, {*direct}, incumbent);
  if (!best) return std::nullopt;
  const auto holds_all = [&] {
    return std::includes(best->inliers.begin(), best->inliers.end(), clique.begin(), clique.end());
  };
  if (holds_all()) return best;
  const double in_clique = problem.objective().evidence_of(clique, best->pose.scale());
  if (in_clique <= incumbent.evidence()) return best;
  // a clique around the best pose so far has no part worth the stages
  if (incumbent.is_near(best->inliers)) return best;
  best = refine::hold_all(problem, clique, std::move(*best));
  if (holds_all() || needs_too_much(in_clique, best->evidence, incumbent.evidence())) return best;
  const auto staged = staged_pose(problem, run, clique);
  if (!staged) return best;
  ++run.diagnostics().num_candidates;
  const auto other = refine::optimise_locally(problem, *staged, incumbent);
  return other && problem::is_better(*other, *best) ? other : best;
}

}  // namespace gmcr::search
