#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace gmcr {

inline constexpr double kLeastSeconds = 1e-3;  ///< that a solver needs to say that it has no time

/// Point in time at which work has to end. The only place of the library that reads a clock to
/// decide.
class Deadline {
 public:
  /// @param seconds  from now; infinity for never.
  explicit Deadline(double seconds) : start_(Clock::now()), seconds_(seconds) {}

  static Deadline never() { return Deadline(std::numeric_limits<double>::infinity()); }

  bool expired() const { return elapsed() >= seconds_; }

  /// Seconds left, >= 0; infinity where there is no limit.
  double remaining() const { return std::max(0.0, seconds_ - elapsed()); }

  /// Seconds since construction.
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double seconds_;
};

}  // namespace gmcr
