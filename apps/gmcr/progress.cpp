#include "progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

namespace gmcr::cli {
namespace {

constexpr double kTerminalPeriod = 0.2;
constexpr double kLogPeriod = 10;

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (is_shown_ && is_terminal_) fmt::print(stderr, "\r\033[K");
}

ProgressCallback ProgressLine::callback() {
  return [this](const Progress& progress) {
    show(progress);
    return true;
  };
}

void ProgressLine::show(const Progress& progress) {
  const double seconds = stopwatch_.seconds();
  if (seconds < next_) return;
  next_ = seconds + (is_terminal_ ? kTerminalPeriod : kLogPeriod);
  is_shown_ = true;
  fmt::print(stderr, "{}{} {:.0f} % ({:.0f} s){}",
             is_terminal_ ? "\r\033[K" : "gmcr: ", progress.stage, 100 * progress.fraction, seconds,
             is_terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace gmcr::cli
