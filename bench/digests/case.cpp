#include "digests/case.hpp"

namespace gmcr::bench {

std::uint64_t seed_of(const std::string& name) {
  Digest digest;
  digest.add(std::string_view(name));
  return digest.hash();
}

}  // namespace gmcr::bench
