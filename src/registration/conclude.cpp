#include "registration/conclude.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "registration/certificate.hpp"
#include "registration/degeneracy.hpp"
#include "registration/uncertainty.hpp"

namespace gmcr {
namespace {

/// The poses judged on all of the input, best first.
/// @param weights  null: those of `on_input`.
std::vector<Hypothesis> judge_all(const std::vector<Similarity>& poses, const Objective* weights,
                                  const Objective& on_input) {
  std::vector<Hypothesis> judged;
  for (const Similarity& pose : poses) {
    Hypothesis hypothesis = on_input.judge(pose);
    if (weights) hypothesis.evidence = weights->evidence_of(hypothesis.inliers, pose.scale);
    if (hypothesis.num_inliers() >= kMinInliers) judged.push_back(std::move(hypothesis));
  }
  std::stable_sort(judged.begin(), judged.end(), is_better);
  return judged;
}

/// Those of the others that share too little with any better one to be the same pose.
std::vector<Alternative> distinct_alternatives(std::vector<Hypothesis> judged) {
  std::vector<Alternative> alternatives;
  for (std::size_t k = 1; k < judged.size(); ++k) {
    const bool is_new = std::none_of(
        judged.begin(), judged.begin() + static_cast<std::ptrdiff_t>(k),
        [&](const Hypothesis& better) { return shares_most(better.inliers, judged[k].inliers); });
    if (!is_new) continue;
    alternatives.push_back({judged[k].target_from_source, judged[k].inliers, judged[k].evidence});
  }
  return alternatives;
}

/// Fills what the residuals of the inliers say of the transform.
void describe_uncertainty(Result& result, SolveContext& context, const Correspondences& input) {
  const StageTimer timer(context, "uncertainty");
  Uncertainty uncertainty = measure_uncertainty(result.target_from_source, input, result.inliers,
                                                context.options(), context.deadline());
  result.consistent_scales = uncertainty.consistent_scales;
  if (result.status == Status::Ok) result.covariance = std::move(uncertainty.covariance);
}

}  // namespace

void conclude(Result& result, SolveContext& context, const MethodResult& found,
              const Correspondences& input, const Objective& objective) {
  const Options& options = context.options();
  // where all were used, their weights are known
  const bool all_used = objective.correspondences().size() == input.size();
  const Objective on_input(input, all_used ? Evidence::Count : options.evidence,
                           options.memory_limit / 4, DistinctEvidence::kAllScales,
                           objective.octaves());
  double evidence_upper_bound = found.evidence_upper_bound;
  if (!on_input.weights_complete()) {
    context.limit("the memory budget does not suffice for distinct evidence: inliers were counted");
    evidence_upper_bound = static_cast<double>(found.upper_bound);
  }
  std::vector<Hypothesis> judged =
      judge_all(found.poses, all_used ? &objective : nullptr, on_input);
  if (judged.empty()) {
    result.status = Status::NoConsensus;
    result.status_reason = "no pose found has 3 inliers";
    result.certificate = certify(0, found.upper_bound, 0, evidence_upper_bound);
    return;
  }
  const Hypothesis& best = judged.front();
  result.certificate =
      certify(best.num_inliers(), found.upper_bound, best.evidence, evidence_upper_bound);
  result.target_from_source = best.target_from_source;
  result.inliers = best.inliers;
  result.evidence = best.evidence;
  result.status_reason = degeneracy_reason(input.source, best.target_from_source, best.inliers,
                                           input.bounds(best.inliers).maxCoeff(), options);
  result.status = result.status_reason.empty() ? Status::Ok : Status::Degenerate;
  result.alternatives = distinct_alternatives(std::move(judged));
  describe_uncertainty(result, context, input);
}

}  // namespace gmcr
