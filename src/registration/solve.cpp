#include "registration/solve.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "paper/paper_method.hpp"
#include "proof/improve.hpp"
#include "proof/tighten.hpp"
#include "refine/likely_pose.hpp"
#include "registration/answer.hpp"
#include "registration/other_bounds.hpp"
#include "search/best_poses.hpp"
#include "search/sampled_search.hpp"

namespace gmcr::registration {
namespace {

using problem::Found;
using problem::Problem;
using problem::Run;

/// `Method::Gmcr`: the best pose (L5, L7), on request the proof that it is one, and other answers.
Found find_by_search(const Problem& problem, Run& run) {
  if (problem.is_sampled()) return search::sampled_search(problem, run);
  search::BestPoseSearch search(problem, run);
  problem.options().certify ? proof::tighten(search) : proof::improve(search);
  Found found = search.found();
  if (search.poses().best()) {
    search::add_alternatives(problem, run, *search.poses().best(), found);
  }
  return found;
}

/// Bounds on all inliers of a pose from those on sets of which no two share a point.
///
/// Let nu(S) be the size of a largest one-to-one subset of S. Adding a correspondence to S raises
/// nu by at most 1, so |S| - nu(S) never falls as S grows: |S| <= nu(S) + |all| - nu(all), and any
/// one-to-one subset of all has at most nu(all). Each of the others gives evidence of at most 1.
void bound_all_inliers(Found& found, const Problem& problem) {
  std::vector<Index> all(static_cast<std::size_t>(problem.size()));
  std::iota(all.begin(), all.end(), Index{0});
  const auto others = problem.size() - static_cast<Index>(problem.filter().one_to_one(all).size());
  found.upper_bound = std::min(problem.size(), found.upper_bound + others);
  found.evidence_upper_bound += static_cast<double>(others);
}

/// What is returned near each pose that was found: the likeliest one, in time. The paper's poses
/// stay as they are.
std::vector<problem::CentredPose> fitted_poses(const Problem& problem, const Found& found,
                                               Run& run) {
  if (problem.options().method == Method::Paper || problem.is_hurried()) return found.poses;
  // a stop is said even where the search had ended
  if (run.cancelled() && run.stopped()) return found.poses;
  const problem::StageTimer timer(run, "fit");
  return refine::most_likely_poses(problem, found.poses);
}

Result solve_at_bound(const PointsRef& source, const PointsRef& target, const Options& options) {
  Run run(options);
  const Problem problem(source, target, options, run);
  const Found found = find(problem, run);
  return answer(problem, found, fitted_poses(problem, found, run), run);
}

}  // namespace

Found find(const Problem& problem, Run& run) {
  if (problem.is_too_small()) {
    return {{}, problem.size(), static_cast<double>(problem.size())};
  }
  Found found = problem.options().method == Method::Paper ? paper::solve(problem, run)
                                                          : find_by_search(problem, run);
  if (!problem.is_sampled()) bound_all_inliers(found, problem);
  return found;
}

Result solve(const PointsRef& source, const PointsRef& target, const Options& options) {
  return at_surest_bound(solve_at_bound(source, target, options), source, target, options,
                         solve_at_bound);
}

}  // namespace gmcr::registration
