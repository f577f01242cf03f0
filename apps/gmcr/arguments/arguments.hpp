#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "arguments/noise_arguments.hpp"
#include "arguments/option_flags.hpp"
#include "arguments/output_arguments.hpp"
#include "arguments/priors_arguments.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/io.hpp"
#include "gmcr/options.hpp"
#include "input/input_file.hpp"

namespace gmcr::cli {

/// Adds `--scale`, `--scale-mode`, and `--estimate-scale` for its 'estimated'.
void add_scale(CLI::App& command, Options& options);

/// Adds `--require`: the least verdict with which the tool says that a pose was found.
void add_required_verdict(CLI::App& command, Verdict& required);

/// Limits on the search for several instances, with `--instances`, which asks for it.
struct InstanceArguments {
  InstanceOptions limits;

  void add_to(CLI::App& command);

  /// Whether the command line asked for instances.
  static bool are_wanted(const CLI::App& command) { return command.count("--max-instances") > 0; }
};

/// Solver options as they are given on the command line.
struct SolverArguments {
  Options options;
  NoiseArguments noise;
  PriorsArguments priors;

  /// Adds what every solve takes, but for the noise bound, whose default differs.
  void add_to(CLI::App& command);

  /// The options with what the command line gave. A noise bound may still be missing.
  /// @throws InvalidOption; IoError where the initial pose cannot be read.
  Options resolved() const;
};

/// Options of how a cloud is read, in a group of their own.
void add_reading(CLI::App& command, CloudOptions& reading);

/// Two clouds and how to match them: what `register` and `match` share.
struct CloudArguments {
  std::string source;
  std::string target;
  FrontendOptions frontend;
  CloudOptions reading;

  /// @param selection  of the front end's options; null: all.
  void add_to(CLI::App& command, const Selection& selection = nullptr);
};

/// The files of two clouds, of which one may be stdin.
struct CloudFiles {
  InputFile source;
  InputFile target;

  /// @throws std::invalid_argument where both are stdin.
  explicit CloudFiles(const CloudArguments& clouds);
};

}  // namespace gmcr::cli
