#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "noise_arguments.hpp"
#include "priors_arguments.hpp"

namespace gmcr::cli {

/// Adds `--name VALUE` with one of the names of `values`; help shows the current value as the
/// default.
template <typename Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Enum& value,
                        const std::map<std::string, Enum>& values, const std::string& help) {
  std::string names, current;
  for (const auto& [text, candidate] : values) {
    names += (names.empty() ? "" : "|") + text;
    if (candidate == value) current = text;
  }
  const auto parse = [&value, values, name, names](const CLI::results_t& given) {
    const auto found = values.find(given.front());
    if (found == values.end()) {
      throw CLI::ValidationError(name, "'" + given.front() + "' is none of " + names);
    }
    value = found->second;
    return true;
  };
  return command.add_option(name, parse, help)->type_name(names)->default_str(current)->expected(1);
}

/// Solver options as they are given on the command line.
struct SolverArguments {
  Options options;
  NoiseArguments noise;
  std::vector<double> scale_range;
  PriorsArguments priors;

  /// Adds what every solve takes, but for the noise bound, whose default differs.
  void add_to(CLI::App& command);

  /// The options with what the command line gave.
  /// @throws as `PriorsArguments::resolved`.
  Options resolved() const;
};

/// Two clouds and how to match them: what `register` and `match` share.
struct CloudArguments {
  std::string source;
  std::string target;
  FrontendOptions frontend;
  std::vector<double> source_viewpoint;
  std::vector<double> target_viewpoint;

  void add_to(CLI::App& command);
  FrontendOptions resolved() const;
};

}  // namespace gmcr::cli
