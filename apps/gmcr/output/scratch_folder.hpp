#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "gmcr/io.hpp"
#include "output/held_signals.hpp"

namespace gmcr::cli {

/// A folder of its own that goes with the object, also where a signal ends the program: that waits
/// until then.
class ScratchFolder {
 public:
  /// @throws IoError where it cannot be made.
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gmcr-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw IoError(name, 0, "cannot be made");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  HeldSignals signals_;  // first, so that it goes last
  std::filesystem::path path_;
};

}  // namespace gmcr::cli
