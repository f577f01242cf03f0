#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "gmcr/clique.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::cli {

/// Which options a command has, by name; null: all.
using Selection = std::function<bool(const std::string& name)>;

/// "gravity.max_tilt" is "--gravity-max-tilt" on the command line.
std::string flag_of(const std::string& option);

/// Both names of an option that has an alias, such as "--num-threads,--threads".
std::string flags_of(const std::string& option, const std::string& alias);

// Each adds a flag for each option of the table that a line of text can give: numbers, words,
// switches, vectors and ranges. What is given goes into `values`, whose values are the defaults.
// What has no flag is for the command itself: lists, priors and callbacks.
void add_flags(CLI::App& command, Options& values, const Selection& selection = nullptr);
void add_flags(CLI::App& command, FrontendOptions& values, const Selection& selection = nullptr);
void add_flags(CLI::App& command, InstanceOptions& values, const Selection& selection = nullptr);
void add_flags(CLI::App& command, CliqueOptions& values, const Selection& selection = nullptr);
void add_flags(CLI::App& command, SyntheticOptions& values, const Selection& selection = nullptr);

/// The message with each option by the name that the command line used for it.
std::string as_written(std::string message, const CLI::App& app, int argc, char** argv);

}  // namespace gmcr::cli
