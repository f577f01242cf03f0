#include "registration/answer.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "estimation/prior_projection.hpp"
#include "proof/certificate.hpp"
#include "registration/degeneracy.hpp"
#include "registration/uncertainty.hpp"

namespace gmcr::registration {
namespace {

using problem::CallerHypothesis;
using problem::CallerObjective;
using problem::Found;
using problem::Problem;
using problem::Run;

/// The poses between the caller's frames, as the priors admit them.
std::vector<problem::CallerPose> admitted_poses(const Problem& problem, const Found& found) {
  std::vector<problem::CallerPose> poses;
  for (const problem::CentredPose& centred : found.poses) {
    const auto admitted = estimation::admitted_pose(
        problem::uncentre(centred, problem.correspondences()).similarity, problem.options());
    if (admitted) poses.push_back({*admitted});
  }
  return poses;
}

/// The poses judged on all of the input, best first.
/// @param weights  null: those of `on_input`.
std::vector<CallerHypothesis> judge_all(const std::vector<problem::CallerPose>& poses,
                                        const problem::Objective* weights,
                                        const CallerObjective& on_input) {
  std::vector<CallerHypothesis> judged;
  for (const problem::CallerPose& pose : poses) {
    CallerHypothesis hypothesis = on_input.judge(pose);
    if (weights) hypothesis.evidence = weights->evidence_of(hypothesis.inliers, pose.scale());
    if (hypothesis.num_inliers() >= problem::kMinInliers) judged.push_back(std::move(hypothesis));
  }
  std::stable_sort(judged.begin(), judged.end(), problem::is_better<problem::Frame::Caller>);
  return judged;
}

/// Those of the others that share too little with any better one to be the same pose.
std::vector<Alternative> distinct_alternatives(std::vector<CallerHypothesis> judged) {
  std::vector<Alternative> alternatives;
  for (std::size_t k = 1; k < judged.size(); ++k) {
    const bool is_new =
        std::none_of(judged.begin(), judged.begin() + static_cast<std::ptrdiff_t>(k),
                     [&](const CallerHypothesis& better) {
                       return problem::shares_most(better.inliers, judged[k].inliers);
                     });
    if (!is_new) continue;
    alternatives.push_back({judged[k].pose.similarity, judged[k].inliers, judged[k].evidence});
  }
  return alternatives;
}

/// Fills what the residuals of the inliers say of the transform.
void describe_uncertainty(Result& result, const Problem& problem, Run& run) {
  const problem::StageTimer timer(run, "uncertainty");
  Uncertainty uncertainty = measure_uncertainty({result.target_from_source}, problem.input(),
                                                result.inliers, problem.options(), run.deadline());
  result.consistent_scales = uncertainty.consistent_scales;
  if (result.status == Status::Ok) result.covariance = std::move(uncertainty.covariance);
}

/// An answer without a pose.
Result no_pose(Status status, const std::string& reason, const Found& found,
               double evidence_upper_bound) {
  Result result;
  result.status = status;
  result.status_reason = reason;
  result.certificate = proof::certify(0, found.upper_bound, 0, evidence_upper_bound);
  return result;
}

Result too_small(const Problem& problem, const Found& found) {
  const std::string count = std::to_string(problem.size()) + " correspondences; 3 are needed";
  return problem.size() == problem.input().size()
             ? no_pose(Status::TooFewCorrespondences, count, found, found.evidence_upper_bound)
             : no_pose(Status::NoConsensus, "the priors on the translation admit " + count, found,
                       found.evidence_upper_bound);
}

std::string no_pose_reason(const Problem& problem, const Run& run) {
  if (!run.diagnostics().limits_hit.empty()) {
    return "no pose was found before a limit ended the search";
  }
  return problem.options().admit_all()
             ? "no three correspondences agree on a pose"
             : "no three correspondences agree on a pose that the priors admit, as far as was "
               "found";
}

Result judged_answer(const Problem& problem, const Found& found, Run& run) {
  const std::vector<problem::CallerPose> poses = admitted_poses(problem, found);
  if (poses.empty()) {
    return no_pose(Status::NoConsensus, no_pose_reason(problem, run), found,
                   static_cast<double>(found.upper_bound));
  }
  // where all were used, their weights are known
  const Options& options = problem.options();
  const bool all_used = problem.size() == problem.input().size();
  const CallerObjective on_input(problem.input(), all_used ? Evidence::Count : options.evidence,
                                 options.memory_limit / 4, problem::DistinctEvidence::kAllScales,
                                 problem.buckets());
  double evidence_upper_bound = found.evidence_upper_bound;
  if (!on_input.weights_complete()) {
    run.limit(problem::weights_incomplete());
    evidence_upper_bound = static_cast<double>(found.upper_bound);
  }
  std::vector<CallerHypothesis> judged =
      judge_all(poses, all_used ? &problem.objective() : nullptr, on_input);
  if (judged.empty()) {
    return no_pose(Status::NoConsensus, "no pose found has 3 inliers", found, evidence_upper_bound);
  }
  const CallerHypothesis& best = judged.front();
  Result result;
  result.certificate =
      proof::certify(best.num_inliers(), found.upper_bound, best.evidence, evidence_upper_bound);
  result.target_from_source = best.pose.similarity;
  result.inliers = best.inliers;
  result.evidence = best.evidence;
  result.status_reason =
      degeneracy_reason(problem.input().source, best.pose.similarity, best.inliers,
                        problem.input().bounds(best.inliers).maxCoeff(), options);
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
  result.alternatives = distinct_alternatives(std::move(judged));
  describe_uncertainty(result, problem, run);
  return result;
}

}  // namespace

Result answer(const Problem& problem, const Found& found, Run& run) {
  Result result =
      problem.is_too_small() ? too_small(problem, found) : judged_answer(problem, found, run);
  result.diagnostics = run.record();
  return result;
}

}  // namespace gmcr::registration
