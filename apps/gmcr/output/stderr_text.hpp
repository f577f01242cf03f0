#pragma once

#include <cstdio>
#include <string>

namespace gmcr::cli {

/// Writes to stderr what it takes. That it is full or closed is no reason to fail: fmt::print would
/// throw where nothing catches.
inline void print_to_stderr(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace gmcr::cli
