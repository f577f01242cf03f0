#pragma once

#include <chrono>
#include <exception>
#include <future>
#include <stop_token>
#include <thread>
#include <utility>

#include "conversion/convert.hpp"
#include "gmcr/options.hpp"

namespace gmcr::python {

/// Between two looks for signals.
inline constexpr auto kSignalPeriod = std::chrono::milliseconds(10);

/// Calls work(options) on a thread of its own, without the GIL, with options that can be stopped.
/// Meanwhile this thread looks for signals such as Ctrl-C, which stop the work; the exception that
/// their handler raised is thrown once it has ended.
template <class Options, class Work>
auto interruptible(const Options& options, Work&& work) {
  Options watched = options;
  std::packaged_task<decltype(work(options))(std::stop_token)> task([&](std::stop_token stop) {
    watched.stop = std::move(stop);
    return work(std::as_const(watched));
  });
  auto result = task.get_future();
  std::exception_ptr interrupt;
  {
    const nb::gil_scoped_release no_gil;
    std::jthread worker(std::move(task));
    while (result.wait_for(kSignalPeriod) != std::future_status::ready) {
      if (interrupt) continue;
      const nb::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() == 0) continue;
      interrupt = std::make_exception_ptr(nb::python_error());
      worker.request_stop();
    }
  }
  if (interrupt) std::rethrow_exception(interrupt);
  return result.get();
}

}  // namespace gmcr::python
