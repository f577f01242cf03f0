#pragma once

#include <chrono>
#include <utility>

#include "convert.hpp"
#include "gmcr/options.hpp"

namespace gmcr::python {

/// Between two looks for signals.
inline constexpr auto kSignalPeriod = std::chrono::milliseconds(10);

/// Calls solve(options) without the GIL. Now and then the solver reports its progress; then signals
/// such as Ctrl-C are looked for, and end the solve with the exception that their handler raised.
template <class Solve>
auto interruptible(const Options& options, Solve&& solve) {
  using Clock = std::chrono::steady_clock;
  Options watched = options;
  watched.progress = [user = options.progress, last = Clock::now()](const Progress& now) mutable {
    if (Clock::now() - last > kSignalPeriod) {
      const nb::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      last = Clock::now();
    }
    return !user || user(now);
  };
  auto result = [&] {
    const nb::gil_scoped_release no_gil;
    return solve(std::as_const(watched));
  }();
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
  return result;
}

}  // namespace gmcr::python
