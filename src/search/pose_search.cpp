#include "search/pose_search.hpp"

#include <algorithm>
#include <utility>

#include "estimation/fits/constrained_fit.hpp"

namespace gmcr::search {
namespace {

/// Part of the evidence of the best pose that an alternative has at least. Where much speaks for
/// the best one, most of the time would go into telling apart what chance gives beside it.
constexpr double kLeastAlternative = 0.25;

}  // namespace

PoseSearch::PoseSearch(const problem::Problem& problem, problem::Run& run,
                       std::vector<problem::Hypothesis> left_out)
    : problem_(problem), run_(run), left_out_(std::move(left_out)) {
  if (left_out_.empty()) return;
  least_evidence_ = kLeastAlternative * left_out_.front().evidence;
  most_.inliers = most_.evidence = least_evidence_;
}

void PoseSearch::try_clique(const std::vector<Index>& clique) {
  const StageTimer timer(run_, "pose");
  if (!examined_.insert(clique).second) return;
  const problem::Correspondences& c = problem_.correspondences();
  const auto fit = estimation::fit_pose(c.source, c.target, c.bounds,
                                        problem_.clear_of_rounding(clique), problem_.constraints());
  if (!fit) return;
  ++run_.diagnostics().num_candidates;
  // L7: the clique was a candidate; the objective on all correspondences decides
  std::optional<problem::Hypothesis> pose = refine::optimise_locally(problem_, {*fit}, incumbent());
  if (pose) offer(std::move(*pose));
}

void PoseSearch::try_pose(const problem::CentredPose& pose) {
  const StageTimer timer(run_, "pose");
  ++run_.diagnostics().num_candidates;
  const problem::Correspondences& c = problem_.correspondences();
  problem::Hypothesis judged = problem_.objective().judge(pose);
  // what its rounding alone holds has no say in the pose
  const std::vector<Index> clear = problem_.clear_of_rounding(judged.inliers);
  if (!problem_.constraints().priors.admit_all() || clear.size() < judged.inliers.size()) {
    const auto fitted =
        estimation::fit_pose(c.source, c.target, c.bounds, clear, problem_.constraints());
    if (!fitted) return;
    judged = problem_.objective().judge({*fitted});
  }
  offer(std::move(judged));
}

void PoseSearch::start_from(const problem::Hypothesis& pose) {
  ++run_.diagnostics().num_candidates;
  if (pose.num_inliers() >= problem_.min_inliers()) note(pose);
}

refine::Incumbent PoseSearch::incumbent() const {
  constexpr int kPatience = 5;
  return {best_ ? &*best_ : nullptr, num_in_vain_ >= kPatience};
}

void PoseSearch::offer(problem::Hypothesis pose) {
  if (incumbent().is_near(pose.inliers)) ++num_in_vain_;
  if (!reached_.insert(pose.inliers).second) return;
  // a challenger is measured by what it can hold, as the best so far was
  const problem::Hypothesis reached =
      refine::hold_more(problem_, std::move(pose), incumbent().evidence());
  for (const problem::Hypothesis& known : left_out_) {
    if (problem::shares_most(known.inliers, reached.inliers)) return;
  }
  note(reached);
}

void PoseSearch::note(const problem::Hypothesis& reached) {
  if (reached.evidence < least_evidence_) return;
  const std::vector<Index> members = problem_.filter().one_to_one(reached.inliers);
  most_.inliers = std::max(most_.inliers, static_cast<double>(members.size()));
  most_.evidence =
      std::max(most_.evidence, problem_.objective().evidence_of(members, reached.pose.scale()));
  if (best_ && !problem::is_better(reached, *best_)) return;
  best_ = reached;
  num_in_vain_ = 0;
}

std::vector<Index> PoseSearch::near_best(double factor) const {
  if (!best_) return {};
  return problem_.objective().within(best_->pose, factor);
}

void PoseSearch::report_early_ends(const PerMeasure& bounds) {
  for (const auto& [measure, sentences] : early_ends_) {
    if (!exceeds(bounds.of(measure), to_beat(measure))) continue;
    for (const auto& [sentence, limit] : sentences) run_.limit({limit, sentence});
  }
}

}  // namespace gmcr::search
