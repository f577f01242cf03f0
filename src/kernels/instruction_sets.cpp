#include <hwy/highway.h>
#include <hwy/targets.h>

#include "gmcr/isa.hpp"

namespace gmcr {

std::vector<std::string> supported_isas() {
  std::vector<std::string> names;
  // a target of fewer bits is the better one
  for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    names.emplace_back(hwy::TargetName(rest & -rest));
  }
  return names;
}

std::string active_isa() { return supported_isas().front(); }

}  // namespace gmcr
