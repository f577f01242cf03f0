#pragma once

#include <chrono>

namespace gmcr::parallel {

/// Measures the wall time since it was made.
class Stopwatch {
 public:
  /// Seconds since construction.
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace gmcr::parallel
