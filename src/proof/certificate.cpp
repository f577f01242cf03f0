#include "proof/certificate.hpp"

#include <algorithm>

namespace gmcr::proof {

Certificate certify(Index lower, Index upper, double evidence, double evidence_upper) {
  constexpr double kRounding = 1e-9;  // of sums of weights
  upper = std::max(lower, upper);
  evidence_upper = std::max(evidence, std::min(evidence_upper, static_cast<double>(upper)));
  return {lower,
          upper,
          lower == upper,
          {evidence, evidence_upper, evidence_upper <= evidence * (1 + kRounding)},
          {},
          {}};
}

}  // namespace gmcr::proof
