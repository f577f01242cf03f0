#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gmcr::cli {

// Scripts for shells that complete commands, options, the words that an option takes, and files:
// made from what `--help` is made from.

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace gmcr::cli
