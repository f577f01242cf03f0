#pragma once

#include <gtest/gtest.h>

#include "forced_isa.hpp"

namespace gmcr::testing {

/// Calls check() with each instruction set forced in turn; failures say which.
template <typename Check>
void for_each_isa(const Check& check) {
  for (const std::int64_t target : available_isas()) {
    SCOPED_TRACE(hwy::TargetName(target));
    const ForcedIsa forced(target);
    check();
  }
}

}  // namespace gmcr::testing
