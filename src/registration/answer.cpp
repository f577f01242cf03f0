#include "registration/answer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "proof/certificate.hpp"
#include "registration/degeneracy.hpp"
#include "registration/uncertainty.hpp"

namespace gmcr::registration {
namespace {

/// The poses judged on all of the input, best first.
/// @param weights  null: those of `on_input`.
std::vector<problem::Hypothesis> judge_all(const std::vector<Similarity>& poses,
                                           const problem::Objective* weights,
                                           const problem::Objective& on_input) {
  std::vector<problem::Hypothesis> judged;
  for (const Similarity& pose : poses) {
    problem::Hypothesis hypothesis = on_input.judge(pose);
    if (weights) hypothesis.evidence = weights->evidence_of(hypothesis.inliers, pose.scale);
    if (hypothesis.num_inliers() >= problem::kMinInliers) judged.push_back(std::move(hypothesis));
  }
  std::stable_sort(judged.begin(), judged.end(), problem::is_better);
  return judged;
}

/// Those of the others that share too little with any better one to be the same pose.
std::vector<Alternative> distinct_alternatives(std::vector<problem::Hypothesis> judged) {
  std::vector<Alternative> alternatives;
  for (std::size_t k = 1; k < judged.size(); ++k) {
    const bool is_new =
        std::none_of(judged.begin(), judged.begin() + static_cast<std::ptrdiff_t>(k),
                     [&](const problem::Hypothesis& better) {
                       return problem::shares_most(better.inliers, judged[k].inliers);
                     });
    if (!is_new) continue;
    alternatives.push_back({judged[k].target_from_source, judged[k].inliers, judged[k].evidence});
  }
  return alternatives;
}

/// Fills what the residuals of the inliers say of the transform.
void describe_uncertainty(Result& result, problem::SolveContext& context,
                          const problem::Correspondences& input) {
  const problem::StageTimer timer(context, "uncertainty");
  Uncertainty uncertainty = measure_uncertainty(result.target_from_source, input, result.inliers,
                                                context.options(), context.deadline());
  result.consistent_scales = uncertainty.consistent_scales;
  if (result.status == Status::Ok) result.covariance = std::move(uncertainty.covariance);
}

}  // namespace

void conclude(Result& result, problem::SolveContext& context, const search::MethodResult& found,
              const problem::Correspondences& input, const problem::Objective& objective) {
  const Options& options = context.options();
  // where all were used, their weights are known
  const bool all_used = objective.correspondences().size() == input.size();
  const problem::Objective on_input(input, all_used ? Evidence::Count : options.evidence,
                                    options.memory_limit / 4, problem::DistinctEvidence::kAllScales,
                                    objective.octaves());
  double evidence_upper_bound = found.evidence_upper_bound;
  if (!on_input.weights_complete()) {
    context.limit(
        {Limit::Memory,
         "the memory budget does not suffice for distinct evidence: inliers were counted"});
    evidence_upper_bound = static_cast<double>(found.upper_bound);
  }
  std::vector<problem::Hypothesis> judged =
      judge_all(found.poses, all_used ? &objective : nullptr, on_input);
  if (judged.empty()) {
    result.status = Status::NoConsensus;
    result.status_reason = "no pose found has 3 inliers";
    result.certificate = proof::certify(0, found.upper_bound, 0, evidence_upper_bound);
    return;
  }
  const problem::Hypothesis& best = judged.front();
  result.certificate =
      proof::certify(best.num_inliers(), found.upper_bound, best.evidence, evidence_upper_bound);
  result.target_from_source = best.target_from_source;
  result.inliers = best.inliers;
  result.evidence = best.evidence;
  result.status_reason = degeneracy_reason(input.source, best.target_from_source, best.inliers,
                                           input.bounds(best.inliers).maxCoeff(), options);
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
  result.alternatives = distinct_alternatives(std::move(judged));
  describe_uncertainty(result, context, input);
}

}  // namespace gmcr::registration
