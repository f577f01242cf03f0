#pragma once

#include "gmcr/options.hpp"
#include "stopwatch.hpp"

namespace gmcr::cli {

/// Shows on stderr how far work of more than a second has come: one line that is rewritten on a
/// terminal, a line now and then elsewhere.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For `Options::progress`; valid while this object lives.
  ProgressCallback callback();

 private:
  void show(const Progress& progress);

  Stopwatch stopwatch_;
  bool is_terminal_;
  bool is_shown_ = false;
  double next_ = 1;  // seconds at which to print again
};

}  // namespace gmcr::cli
