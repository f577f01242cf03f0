#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "gmcr/io.hpp"
#include "gmcr/options.hpp"

namespace gmcr::cli {

/// The noise bound as it is given on the command line.
struct NoiseArguments {
  NoiseMode mode = NoiseMode::Given;
  std::optional<double> bound;  ///< metres

  /// Adds `--noise-bound B|auto`, and `--noise-mode`, whose 'estimated' is the same as auto.
  CLI::Option* add_to(CLI::App& command, const std::string& help);

  bool is_given() const { return bound || mode == NoiseMode::Estimated; }

  /// Takes the bounds of the file into `options` where it has them.
  /// @throws std::invalid_argument where the noise is given twice or not at all.
  void check_against(const Matches& matches, Options& options) const;
};

}  // namespace gmcr::cli
