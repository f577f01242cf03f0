#include "digests/case.hpp"

#include <stdexcept>

namespace gmcr::bench {

std::uint64_t seed_of(const std::string& name) {
  Digest digest;
  digest.add(std::string_view(name));
  return digest.hash();
}

Cases all_cases() {
  Cases cases;
  add_known_scale(cases);
  add_unknown_scale(cases);
  add_certified(cases);
  add_drawn(cases);
  add_degenerate(cases);
  add_instances(cases);
  add_evaluations(cases);
  add_cliques(cases);
  add_clouds(cases);
  add_real(cases);
  return cases;
}

Digest digest_of(const Case& item, int num_threads) {
  Digest digest;
  try {
    item.solve(digest, num_threads);
  } catch (const std::invalid_argument&) {
    digest.begin("refused");
    digest.add(true);
  }
  return digest;
}

}  // namespace gmcr::bench
