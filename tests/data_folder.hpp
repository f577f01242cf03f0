#pragma once

#include <cstdlib>
#include <filesystem>

namespace gmcr::testing {

/// Where the real data is expected; tests that need it skip where it is absent.
inline std::filesystem::path data_folder() {
  if (const char* folder = std::getenv("GMCR_DATA")) return folder;
  const char* source = std::getenv("GMCR_SOURCE_DIR");
  return std::filesystem::path(source ? source : ".") / "../shared/data";
}

}  // namespace gmcr::testing
