#include "registration/answer.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "estimation/fits/prior_projection.hpp"
#include "proof/certificate.hpp"
#include "registration/judgement/degeneracy.hpp"
#include "registration/judgement/uncertainty.hpp"
#include "registration/judgement/verdict.hpp"

namespace gmcr::registration {
namespace {

using problem::CallerHypothesis;
using problem::CallerObjective;
using problem::Found;
using problem::Problem;
using problem::Run;

/// A pose that was found, and the one that is returned in its place, on all of the input.
struct Judged {
  CallerHypothesis found, returned;
};

/// The pose between the caller's frames, if the priors admit one.
std::optional<problem::CallerPose> admitted_pose(const Problem& problem,
                                                 const problem::CentredPose& centred) {
  const auto admitted = estimation::admitted_pose(
      problem::uncentre(centred, problem.correspondences()).similarity, problem.options());
  if (!admitted) return std::nullopt;
  return problem::CallerPose{*admitted};
}

/// Best first.
/// @param weights  null: those of `on_input`.
std::vector<Judged> judge_all(const Problem& problem, const Found& found,
                              const std::vector<problem::CentredPose>& fitted,
                              const problem::Objective* weights, const CallerObjective& on_input) {
  const auto judge = [&](const problem::CentredPose& centred) -> std::optional<CallerHypothesis> {
    const auto pose = admitted_pose(problem, centred);
    if (!pose) return std::nullopt;
    CallerHypothesis hypothesis = on_input.judge(*pose);
    if (hypothesis.num_inliers() < problem.min_inliers()) return std::nullopt;
    if (weights) hypothesis.evidence = weights->evidence_of(hypothesis.inliers, pose->scale());
    return hypothesis;
  };
  std::vector<Judged> all;
  for (std::size_t k = 0; k < found.poses.size(); ++k) {
    auto held = judge(found.poses[k]);
    if (!held) continue;
    const bool is_same = fitted[k].similarity.matrix() == found.poses[k].similarity.matrix();
    auto returned = is_same ? held : judge(fitted[k]);
    if (!returned) returned = held;
    all.push_back({std::move(*held), std::move(*returned)});
  }
  std::stable_sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
    return problem::is_better(a.found, b.found);
  });
  return all;
}

/// The pose that was found, or the one that is returned where it holds more by either measure.
const CallerHypothesis& most_held(const Judged& judged) {
  const auto& [found, returned] = judged;
  const bool is_more =
      returned.num_inliers() >= found.num_inliers() && returned.evidence >= found.evidence;
  return is_more ? returned : found;
}

/// Those of the others that share too little with any better one to be the same pose.
std::vector<Alternative> distinct_alternatives(std::vector<Judged> judged) {
  std::vector<Alternative> alternatives;
  for (std::size_t k = 1; k < judged.size(); ++k) {
    const CallerHypothesis& other = judged[k].returned;
    const bool is_new = std::none_of(
        judged.begin(), judged.begin() + static_cast<std::ptrdiff_t>(k), [&](const Judged& better) {
          return problem::shares_most(better.returned.inliers, other.inliers);
        });
    if (!is_new) continue;
    alternatives.push_back({other.pose.similarity, other.inliers, other.evidence});
  }
  std::stable_sort(
      alternatives.begin(), alternatives.end(),
      [](const Alternative& a, const Alternative& b) { return a.evidence > b.evidence; });
  return alternatives;
}

/// Fills what the residuals of the inliers say of the transform.
void describe_uncertainty(Result& result, const Problem& problem, Run& run) {
  if (problem.is_hurried() || run.cancelled()) {
    result.consistent_scales = problem.scales();
    return;
  }
  const problem::StageTimer timer(run, "uncertainty");
  Uncertainty uncertainty = measure_uncertainty({result.target_from_source}, problem.input(),
                                                result.inliers, problem.options(), run.deadline());
  result.consistent_scales = uncertainty.consistent_scales;
  if (result.status == Status::Ok) result.covariance = std::move(uncertainty.covariance);
}

/// An answer without a pose.
Result no_pose(Status status, const std::string& reason, const Problem& problem, const Found& found,
               double evidence_upper_bound) {
  Result result;
  result.status = status;
  result.status_reason = reason;
  result.certificate = proof::certify(0, found.upper_bound, 0, evidence_upper_bound);
  judge_without_pose(result, problem.input().source, problem.input().target, problem.options());
  return result;
}

Result too_small(const Problem& problem, const Found& found) {
  const std::string count = std::to_string(problem.size()) + " correspondences; " +
                            std::to_string(problem.min_inliers()) + " are needed";
  return problem.size() == problem.input().size()
             ? no_pose(Status::TooFewCorrespondences, count, problem, found,
                       found.evidence_upper_bound)
             : no_pose(Status::NoConsensus, "the priors on the translation admit " + count, problem,
                       found, found.evidence_upper_bound);
}

std::string no_pose_reason(const Problem& problem, const Run& run) {
  if (!run.diagnostics().limits_hit.empty()) {
    return "no pose was found before a limit ended the search";
  }
  constexpr const char* kNone[] = {"no correspondence suits", "no two correspondences agree on",
                                   "no three correspondences agree on"};
  const std::string none = kNone[problem.min_inliers() - 1];
  return problem.options().admit_all()
             ? none + " a pose"
             : none + " a pose that the priors admit, as far as was found";
}

Result judged_answer(const Problem& problem, const Found& found,
                     const std::vector<problem::CentredPose>& fitted, Run& run) {
  // where all were used, their weights are known
  const Options& options = problem.options();
  const bool all_used = problem.size() == problem.input().size();
  const bool is_counted = all_used || problem.is_sampled();
  const CallerObjective on_input(problem.input(), is_counted ? Evidence::Count : options.evidence,
                                 options.memory_limit / 4, problem::DistinctEvidence::kAllScales,
                                 problem.buckets(), run.deadline());
  double evidence_upper_bound = found.evidence_upper_bound;
  if (!on_input.weights_complete()) {
    if (!run.stopped()) run.limit(problem::weights_incomplete());
    evidence_upper_bound = static_cast<double>(found.upper_bound);
  }
  std::vector<Judged> judged =
      judge_all(problem, found, fitted, all_used ? &problem.objective() : nullptr, on_input);
  if (judged.empty()) {
    return no_pose(Status::NoConsensus, no_pose_reason(problem, run), problem, found,
                   evidence_upper_bound);
  }
  const CallerHypothesis& returned = judged.front().returned;
  const CallerHypothesis& held = most_held(judged.front());
  Result result;
  result.certificate =
      proof::certify(held.num_inliers(), found.upper_bound, held.evidence, evidence_upper_bound);
  result.certificate.target_from_source = held.pose.similarity;
  result.certificate.inliers = held.inliers;
  result.target_from_source = returned.pose.similarity;
  result.inliers = returned.inliers;
  result.evidence = returned.evidence;
  result.status_reason =
      degeneracy_reason(problem.input().source, returned.pose.similarity, returned.inliers,
                        problem.input().bounds(returned.inliers), options);
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
  result.alternatives = distinct_alternatives(std::move(judged));
  describe_uncertainty(result, problem, run);
  judge(result, problem, run);
  return result;
}

}  // namespace

Result answer(const Problem& problem, const Found& found,
              const std::vector<problem::CentredPose>& fitted, Run& run) {
  Result result = problem.is_too_small() ? too_small(problem, found)
                                         : judged_answer(problem, found, fitted, run);
  result.diagnostics = run.record();
  return result;
}

}  // namespace gmcr::registration
