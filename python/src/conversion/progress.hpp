#pragma once

#include <memory>

#include "conversion/convert.hpp"

namespace gmcr::python {

/// A callable of Python as a `ProgressCallback`: progress(stage, fraction), of which False stops
/// the search. The library copies options without holding the GIL, so copies share one reference.
struct PythonProgress {
  std::shared_ptr<nb::object> callable;

  explicit PythonProgress(nb::handle value)
      : callable(new nb::object(nb::borrow(value)), [](nb::object* object) {
          const nb::gil_scoped_acquire gil;
          delete object;
        }) {}

  bool operator()(const Progress& progress) const {
    const nb::gil_scoped_acquire gil;
    const nb::object answer = (*callable)(progress.stage, progress.fraction);
    return !answer.is(nb::bool_(false));
  }
};

template <>
struct Convert<ProgressCallback> {
  static std::string type() { return "collections.abc.Callable[[str, float], bool | None] | None"; }
  static std::string accepted() { return type(); }
  static nb::object to_python(const ProgressCallback& callback, nb::handle) {
    const auto* python = callback.target<PythonProgress>();
    return python ? *python->callable : nb::none();
  }
  static ProgressCallback from_python(nb::handle value, const char* name) {
    if (value.is_none()) return nullptr;
    if (!PyCallable_Check(value.ptr())) refuse(name, value, "a callable");
    return PythonProgress(value);
  }
};

}  // namespace gmcr::python
