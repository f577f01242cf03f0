#include "frontend/verdict.hpp"

#include <string>

namespace gmcr {

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::Trusted:
      return "trusted";
    case Verdict::Doubtful:
      return "doubtful";
    case Verdict::Untrusted:
      return "untrusted";
  }
  return "unknown";
}

void judge(CloudResult& result) {
  const auto num_inliers = static_cast<Index>(result.registration.inliers.size());
  const std::string count = std::to_string(num_inliers) + " of " +
                            std::to_string(result.matches.source.cols()) + " matches agree";
  if (result.registration.status != Status::Ok) {
    result.verdict = Verdict::Untrusted;
    result.verdict_reason = "there is no pose: " + result.registration.status_reason;
  } else if (num_inliers < 10) {
    result.verdict = Verdict::Untrusted;
    result.verdict_reason = "only " + count + ", which chance explains";
  } else if (num_inliers < 20) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = "only " + count;
  } else if (result.fitness < 0.2) {
    result.verdict = Verdict::Doubtful;
    result.verdict_reason = count + ", but little of the source meets the target";
  } else {
    result.verdict = Verdict::Trusted;
    result.verdict_reason = count;
  }
}

}  // namespace gmcr
