#include "proof/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace gmcr::proof {

Index max_members(Index num_pairs) {
  auto m = static_cast<Index>((1 + std::sqrt(1 + 8 * static_cast<double>(num_pairs))) / 2);
  while (m * (m - 1) / 2 > num_pairs) --m;
  while ((m + 1) * m / 2 <= num_pairs) ++m;
  return m;
}

Certificate certify(Index lower, Index upper, double evidence, double evidence_upper) {
  constexpr double kRounding = 1e-9;  // of sums of weights
  upper = std::max(lower, upper);
  evidence_upper = std::max(evidence, std::min(evidence_upper, static_cast<double>(upper)));
  return {lower,
          upper,
          lower == upper,
          {evidence, evidence_upper, evidence_upper <= evidence * (1 + kRounding)}};
}

}  // namespace gmcr::proof
