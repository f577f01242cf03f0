// The entry of libFuzzer for the target that GMCR_FUZZ_TARGET names.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/target.hpp"

namespace {

const gmcr::fuzz::Target& chosen() {
  for (const gmcr::fuzz::Target& target : gmcr::fuzz::targets()) {
    if (target.name == GMCR_FUZZ_TARGET) return target;
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gmcr::fuzz::Target& target = chosen();
  target.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
