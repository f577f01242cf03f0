#include "search/best_poses.hpp"

#include <algorithm>
#include <utility>

#include "search/conflict_bounds.hpp"
#include "search/scales/scale_modes.hpp"

namespace gmcr::search {
namespace {

constexpr Index kMaxStarts = 64, kMaxStartsOfAlternative = 16;
constexpr std::uint64_t kMaxNodes = 2'000'000;
constexpr std::uint64_t kMaxWeightedNodes = 300;

/// Whether the search may end before it has a pose.
bool time_is_short(const problem::Problem& problem) {
  constexpr double kShare = 0.5;  // of the time, for graphs
  return problem::foreseen_seconds(problem.size(), problem.scale_is_known()) >
         kShare * problem.options().time_limit;
}

/// Whether samples may decide the search: no proof and no clique is asked for, and a graph takes
/// longer.
bool may_be_decided(const problem::Problem& problem) {
  constexpr Index kLeast = 256;
  const Options& options = problem.options();
  return problem.size() >= kLeast && !options.certify && !options.clique_solver;
}

/// Draws that take a quarter of the time of the graphs, so that little is lost where they decide
/// nothing; where the scale is unknown some in any case, as a pose to beat leaves few scales.
Index max_draws(const problem::Problem& problem) {
  constexpr double kShare = 0.25, kSecondsEach = 5e-8;
  constexpr Index kSome = 800;
  const bool scale_is_known = problem.scale_is_known();
  const auto draws = static_cast<Index>(
      kShare * problem::foreseen_seconds(problem.size(), scale_is_known) / kSecondsEach);
  return scale_is_known ? draws : std::max(draws, kSome);
}

/// Whether samples come first.
bool is_worth_samples(const problem::Problem& problem) {
  return may_be_decided(problem) || (!problem.scale_is_known() && !problem.options().certify &&
                                     !problem.options().clique_solver);
}

}  // namespace

BestPoseSearch::BestPoseSearch(const problem::Problem& problem, problem::Run& run,
                               std::vector<problem::Hypothesis> left_out)
    : poses_(problem, run, std::move(left_out)) {
  const bool is_first = poses_.left_out().empty(), is_hurried = is_first && time_is_short(problem);
  bool is_decided = false;
  if (is_hurried) {
    is_decided = start_from_samples({});
  } else if (is_first && is_worth_samples(problem)) {
    is_decided = start_from_samples({max_draws(problem), run.deadline()});
  }
  if (is_decided) return;
  if (problem.size() > problem::kQuickGraph && !problem.options().certify && run.stopped()) {
    bounds_.inliers = bounds_.evidence = static_cast<double>(problem.size());
  } else if (problem.scale_is_known()) {
    search_known_scale();
  } else {
    search_scales();
  }
  // a limit that could not be foreseen, such as the caller's stop
  if (is_first && !is_hurried && !poses_.best() && run.stopped()) start_from_samples({});
  if (!problem.objective().is_weighted()) bounds_.evidence = bounds_.inliers;
}

bool BestPoseSearch::start_from_samples(const SamplingEffort& effort) {
  const problem::Problem& problem = poses_.problem();
  SampledStart start;
  {
    const StageTimer timer(poses_.run(), "start");
    start = sampled_start(problem, effort);
  }
  if (!start.best) return false;
  if (!start.is_decisive || !may_be_decided(problem)) {
    poses_.start_from(*start.best);
    return false;
  }
  {
    const StageTimer timer(poses_.run(), "pose");
    poses_.offer(std::move(*start.best));
  }
  const StageTimer timer(poses_.run(), "bounds");
  bounds_ = bounds_by_conflicts(problem, *poses_.best());
  constexpr const char* kDecided =
      "samples decided the search, as no proof was asked for: the upper bound may be loose";
  poses_.note_early_end(Measure::Inliers, {Limit::CliqueSearch, kDecided});
  poses_.note_early_end(Measure::Evidence, {Limit::EvidenceSearch, kDecided});
  return true;
}

void BestPoseSearch::search_known_scale() {
  const RangeGraph& range = graph_.emplace(build_range_graph(poses_, poses_.problem().scales()));
  bounds_.inliers = search_clique(poses_, range, Measure::Inliers, kMaxNodes);
  // evidence is at most the number of inliers: where that is proven the best, so is the pose
  if (bounds_.inliers > poses_.to_beat(Measure::Evidence)) {
    grow_cliques(poses_, range, poses_.left_out().empty() ? kMaxStarts : kMaxStartsOfAlternative);
  }
  if (!poses_.problem().objective().is_weighted()) return;
  bounds_.evidence =
      std::min(bounds_.inliers, search_clique(poses_, range, Measure::Evidence, kMaxWeightedNodes));
}

void BestPoseSearch::search_scales() {
  explore_modes(poses_, voted_.emplace(poses_));
  scales_.emplace(poses_, *voted_);
  if (poses_.problem().objective().is_weighted()) {
    bounds_.evidence = scales_->lower_upper_bound(Measure::Evidence);
  }
  bounds_.inliers = scales_->lower_upper_bound(Measure::Inliers);
}

problem::Found BestPoseSearch::found() {
  poses_.report_early_ends(bounds_);
  problem::Found found;
  if (poses_.best()) found.poses.push_back(poses_.best()->pose);
  found.upper_bound =
      static_cast<Index>(std::max(bounds_.inliers, poses_.to_beat(Measure::Inliers)));
  found.evidence_upper_bound = std::max(bounds_.evidence, poses_.to_beat(Measure::Evidence));
  return found;
}

void add_alternatives(const problem::Problem& problem, problem::Run& run,
                      const problem::Hypothesis& best, problem::Found& found) {
  std::vector<problem::Hypothesis> known{best};
  // a search that finds no consensus leaves nothing out for the next
  const auto may_go_on = [&] {
    return known.back().num_inliers() >= problem.min_inliers() &&
           static_cast<int>(known.size()) < run.options().num_hypotheses && !run.stopped();
  };
  while (may_go_on()) {
    BestPoseSearch next(problem, run, known);
    if (!next.poses().best()) break;
    known.push_back(*next.poses().best());
    found.poses.push_back(known.back().pose);
  }
}

}  // namespace gmcr::search
