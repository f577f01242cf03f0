#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gmcr::cli {

/// The manual page of all commands, gmcr(1), in roff: made from what `--help` is made from.
std::string manual_page(const CLI::App& app);

}  // namespace gmcr::cli
