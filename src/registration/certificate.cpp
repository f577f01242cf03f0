#include "registration/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace gmcr {

Index max_members(Index num_pairs) {
  auto m = static_cast<Index>((1 + std::sqrt(1 + 8 * static_cast<double>(num_pairs))) / 2);
  while (m * (m - 1) / 2 > num_pairs) --m;
  while ((m + 1) * m / 2 <= num_pairs) ++m;
  return m;
}

Certificate certify(Index lower, Index upper) {
  const EvidenceCertificate evidence{static_cast<double>(lower),
                                     static_cast<double>(std::max(lower, upper)), upper <= lower};
  return {lower, std::max(lower, upper), upper <= lower, evidence};
}

}  // namespace gmcr
