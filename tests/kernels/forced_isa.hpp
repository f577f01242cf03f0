#pragma once

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace gmcr::testing {

/// Hides all instruction sets better than one, as a machine without them does, until destroyed.
class ForcedIsa {
 public:
  explicit ForcedIsa(std::int64_t target) {
    choose(hwy::SupportedTargets() & ~(target - 1));  // a target of fewer bits is the better one
  }
  ~ForcedIsa() { choose(0); }
  ForcedIsa(const ForcedIsa&) = delete;
  ForcedIsa& operator=(const ForcedIsa&) = delete;

 private:
  static void choose(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

/// Those that the machine has and the library was built for, best first. AVX3_DL is that of the few
/// files that ask for it.
inline std::vector<std::int64_t> available_isas() {
  std::vector<std::int64_t> targets;
  const std::int64_t built_for = HWY_TARGETS | HWY_AVX3_DL;
  for (std::int64_t rest = hwy::SupportedTargets() & built_for; rest != 0; rest &= rest - 1) {
    targets.push_back(rest & -rest);
  }
  return targets;
}

}  // namespace gmcr::testing
