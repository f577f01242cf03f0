#include "output/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <string>

#include "gmcr/report.hpp"
#include "output/stderr_text.hpp"
#include "output/stopwatch.hpp"
#include "output/terminal.hpp"

namespace gmcr::cli {
namespace {

constexpr double kFirst = 1;  // seconds
constexpr double kTerminalPeriod = 0.2;
constexpr double kLogPeriod = 10;

}  // namespace

ProgressLine::ProgressLine(bool is_quiet)
    : is_quiet_(is_quiet), is_terminal_(obeys_codes(STDERR_FILENO)), thread_([this] { run(); }) {}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

ProgressCallback ProgressLine::callback() {
  return [this](const Progress& progress) {
    const std::lock_guard lock(mutex_);
    progress_ = progress;
    return true;
  };
}

void ProgressLine::run() {
  const Stopwatch stopwatch;
  bool is_shown = false;
  std::unique_lock lock(mutex_);
  for (double pause = kFirst;; pause = is_terminal_ ? kTerminalPeriod : kLogPeriod) {
    if (ended_.wait_for(lock, std::chrono::duration<double>(pause), [&] { return has_ended_; })) {
      break;
    }
    if (is_quiet_) continue;
    print(stopwatch.seconds());
    is_shown = true;
  }
  if (is_shown && is_terminal_) print_to_stderr("\r\033[K");
}

void ProgressLine::print(double seconds) const {
  const std::string share =
      progress_.fraction > 0 ? fmt::format(" {:.0f} %", 100 * progress_.fraction) : "";
  print_to_stderr(fmt::format("{}{}{} ({:.0f} s){}",
                              is_terminal_ ? "\r\033[K" : "gmcr: ", stage_in_words(progress_.stage),
                              share, seconds, is_terminal_ ? "" : "\n"));
}

}  // namespace gmcr::cli
