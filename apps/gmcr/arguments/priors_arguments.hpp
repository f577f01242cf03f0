#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gmcr/options.hpp"

namespace gmcr::cli {

/// What is known of the transform, as it is given on the command line.
struct PriorsArguments {
  std::vector<double> gravity;  ///< 3 values for both frames, or 3 for each; empty: not given
  std::optional<double> max_tilt_deg;
  std::string initial_pose;  ///< path of a transform or a result; empty: not given
  std::optional<double> max_rotation_error_deg;
  std::optional<double> max_translation_error;

  void add_to(CLI::App& command);

  /// Sets the priors that were given, but for the longest translation, which is plain.
  /// @throws IoError where the initial pose cannot be read, std::invalid_argument where it has no
  ///   limit.
  void add_to(Options& options) const;
};

}  // namespace gmcr::cli
