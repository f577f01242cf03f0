#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "gmcr/options.hpp"

namespace gmcr::cli {

/// Shows on stderr that work of more than a second goes on, and at which stage it is: one line that
/// is rewritten on a terminal, a line now and then elsewhere.
class ProgressLine {
 public:
  /// @param is_quiet  shows nothing.
  explicit ProgressLine(bool is_quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For `Options::progress`; valid while this object lives.
  ProgressCallback callback();

 private:
  void run();
  void print(double seconds) const;

  const bool is_quiet_;
  const bool is_terminal_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable ended_;
  bool has_ended_ = false;
  Progress progress_{"start", 0};
  std::thread thread_;  // last: it uses the others
};

}  // namespace gmcr::cli
