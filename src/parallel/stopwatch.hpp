#pragma once

#include <chrono>

namespace gmcr {

/// The time since its construction.
class Stopwatch {
 public:
  /// Seconds.
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace gmcr
