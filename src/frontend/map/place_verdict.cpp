#include "frontend/map/place_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace gmcr::frontend {
namespace {

// Of the scan: at least 0.57 at right places of a town, at most 0.63 at places of another town.
constexpr double kTrustedShare = 0.5;
// Of the best place: at most 0.66 and at least 0.8.
constexpr double kClearRunnerUp = 0.75;

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

}  // namespace

void judge_place(CloudResult& result, double runner_up) {
  const double share = result.surfaces.source_share;
  const std::string covered = "the map covers " + percent(share) + " of the scan, and " +
                              percent(runner_up * share) + " of it at the next best place";
  Verdict verdict = Verdict::Trusted;
  const bool is_covered = share >= kTrustedShare, is_clear = runner_up <= kClearRunnerUp;
  if (!is_covered || !is_clear) verdict = Verdict::Doubtful;
  if (!is_covered && !is_clear) verdict = Verdict::Untrusted;
  if (result.verdict == Verdict::Trusted) {
    result.verdict_reason = covered;
  } else {
    result.verdict_reason = covered + "; " + result.verdict_reason;
  }
  result.verdict = std::max(result.verdict, verdict);
}

}  // namespace gmcr::frontend
