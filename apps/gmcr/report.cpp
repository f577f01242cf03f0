#include "report.hpp"

#include <unistd.h>

#include <cstdlib>

namespace gmcr::cli {
namespace {

fmt::text_style style_of(Report::Tone tone) {
  switch (tone) {
    case Report::Tone::Good:
      return fmt::fg(fmt::terminal_color::green);
    case Report::Tone::Fair:
      return fmt::fg(fmt::terminal_color::yellow);
    default:
      return fmt::fg(fmt::terminal_color::red);
  }
}

}  // namespace

Report::Report() : is_terminal_(isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR")) {}

void Report::line(std::string_view label, std::string_view text) {
  text_ += fmt::format("{:<13} {}\n", label, text);
}

void Report::line(std::string_view label, std::string_view text, Tone tone) {
  line(label, is_terminal_ ? fmt::format(style_of(tone), "{}", text) : std::string(text));
}

void Report::print() const { fmt::print("{}", text_); }

std::string share(Index part, Index whole) {
  if (whole == 0) return fmt::format("{} of 0", part);
  return fmt::format("{} of {} ({:.1f} %)", part, whole,
                     100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string duration(double seconds) {
  return seconds < 1 ? fmt::format("{:.2f} ms", 1000 * seconds) : fmt::format("{:.2f} s", seconds);
}

}  // namespace gmcr::cli
