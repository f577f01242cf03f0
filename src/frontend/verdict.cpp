#include "frontend/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace gmcr::frontend {
namespace {

// Mutual matches that agree: at most 20 in wrong poses of real pairs, at least 38 in right ones.
constexpr Index kChanceInliers = 12;
constexpr Index kTrustedInliers = 30;
// Their distinct evidence, which a loose noise bound does not swell: at most 2.4 and at least 5.8.
constexpr double kTrustedEvidence = 4.5;
// Shares of a cloud that the other covers.
constexpr double kLeastCoverage = 0.2;
constexpr double kPlausibleCoverage = 0.5;

}  // namespace

void judge(CloudResult& result) {
  const bool all_matches = !result.matches.filtered;
  const auto num_inliers = static_cast<Index>(result.registration.inliers.size());
  const double coverage = std::max(result.fitness, result.target_fitness);
  const std::string count = std::to_string(num_inliers) + " of " +
                            std::to_string(result.matches.source.cols()) + " matches agree";
  const std::string meet =
      std::to_string(std::lround(100 * coverage)) + " % of a cloud meets the other";
  if (result.registration.status != Status::Ok) {
    result.verdict = Verdict::Untrusted;
    const bool has_pose = result.registration.status == Status::Degenerate;
    result.verdict_reason = (has_pose ? "the pose is one of many: " : "there is no pose: ") +
                            result.registration.status_reason;
  } else if (all_matches ? coverage < kPlausibleCoverage : num_inliers < kChanceInliers) {
    result.verdict = Verdict::Untrusted;
    result.verdict_reason = count + " and " + meet + ", which chance explains";
  } else if (all_matches || num_inliers < kTrustedInliers ||
             result.distinct_evidence < kTrustedEvidence || coverage < kLeastCoverage) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = "only " + count + " and " + meet;
  } else {
    result.verdict = Verdict::Trusted;
    result.verdict_reason = count + " and " + meet;
  }
}

}  // namespace gmcr::frontend
