#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gmcr::cli {

/// The most similar of the known words, where it is similar enough to have been meant: few letters
/// are missing, too many, wrong or swapped, or the word is the start of one.
std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known);

/// What is wrong with the first word of the command line that names no command, or no option of the
/// command, with what may have been meant; nullopt where all are known.
std::optional<std::string> unknown_word(const CLI::App& app, int argc, char** argv);

}  // namespace gmcr::cli
