#include "arguments/validators.hpp"

#include <fmt/core.h>

#include <charconv>

namespace gmcr::cli {
namespace {

/// Refuses a number for which `holds` is false; NaN never holds.
template <typename Predicate>
CLI::Validator require(Predicate holds, const std::string& rule) {
  return CLI::Validator(
      [holds, rule](std::string& text) {
        const std::optional<double> value = to_number(text);
        if (!value) return "'" + text + "' is no number";
        return holds(*value) ? std::string() : text + " is not " + rule;
      },
      "");
}

}  // namespace

std::optional<double> to_number(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) {
        return text.starts_with('-') ? "'" + text + "' is negative" : std::string();
      },
      "");
}

CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& text) { return std::string(text.empty() ? "'' is no file" : ""); }, "");
}

CLI::Validator at_least(double min) {
  return require([min](double value) { return value >= min; }, fmt::format("at least {}", min));
}

CLI::Validator positive() {
  return require([](double value) { return value > 0; }, "a positive number");
}

CLI::Validator between(double min, double max, const std::string& unit) {
  return require([min, max](double value) { return value >= min && value <= max; },
                 fmt::format("between {} and {}{}{}", min, max, unit.empty() ? "" : " ", unit));
}

}  // namespace gmcr::cli
