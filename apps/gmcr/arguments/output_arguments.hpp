#pragma once

#include <CLI/CLI.hpp>

namespace gmcr::cli {

/// What a command prints: what all commands share.
struct OutputArguments {
  bool json = false;
  bool quiet = false;  ///< no report, no progress, no notes: errors, files and the exit code

  /// Adds `--json` and `-q,--quiet`.
  void add_to(CLI::App& command);
};

}  // namespace gmcr::cli
