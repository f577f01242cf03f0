#pragma once

#include <cstdlib>
#include <string>

namespace gmcr::test {

/// How many times as much a test shall do as in `make test`: `make outsiders` sets GMCR_EFFORT.
inline int effort() {
  const char* text = std::getenv("GMCR_EFFORT");
  return text != nullptr ? std::stoi(text) : 1;
}

}  // namespace gmcr::test
