#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace gmcr::cli {

/// The whole of `text` as a number, whatever the locale.
std::optional<double> to_number(const std::string& text);

/// Refuses a number with a minus sign, which an unsigned option would take for a huge one.
CLI::Validator not_negative();

/// Refuses what is no number of at least `min`.
CLI::Validator at_least(double min);

/// Refuses what is no number above 0.
CLI::Validator positive();

/// Refuses a path that is empty, as a script's variable may be.
CLI::Validator not_empty();

/// Refuses what is no number from `min` to `max`; messages name the unit.
CLI::Validator between(double min, double max, const std::string& unit = "");

}  // namespace gmcr::cli
