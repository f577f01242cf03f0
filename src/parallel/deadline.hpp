#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <stop_token>
#include <utility>

namespace gmcr::parallel {

inline constexpr double kLeastSeconds = 1e-3;  ///< that a solver needs to say that it has no time

/// Point in time at which work has to end, or the moment at which a stop is requested, whichever
/// comes first. The only place of the library that reads a clock to decide.
class Deadline {
 public:
  /// @param seconds  from now; infinity for never.
  /// @param stop     ends it at once, from any thread.
  explicit Deadline(double seconds, std::stop_token stop = {})
      : start_(Clock::now()), seconds_(seconds), stop_(std::move(stop)) {}

  static Deadline never() { return Deadline(std::numeric_limits<double>::infinity()); }

  /// Another one, so many seconds from now, that the same request ends.
  Deadline within(double seconds) const { return Deadline(seconds, stop_); }

  bool expired() const { return stop_.stop_requested() || elapsed() >= seconds_; }

  /// Seconds left, >= 0; infinity where there is no limit.
  double remaining() const {
    return stop_.stop_requested() ? 0.0 : std::max(0.0, seconds_ - elapsed());
  }

  /// Seconds since construction.
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double seconds_;
  std::stop_token stop_;
};

}  // namespace gmcr::parallel
