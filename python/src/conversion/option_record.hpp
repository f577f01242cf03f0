#pragma once

#include "conversion/noise_bound.hpp"
#include "conversion/progress.hpp"
#include "conversion/record.hpp"
#include "options/table.hpp"

namespace gmcr::python {

/// A struct of options as a Python class, with a field for each option of its table.
template <class T>
nb::class_<T> bind_options_of(nb::module_& module, const char* name, const char* doc) {
  Record<T> record(module, name, doc);
  options::for_each_option<T>([&](const auto& option) {
    const std::string text = options::describe(option.about) + ".";
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(option.place)>, double Options::*>) {
      if (option.place == &Options::noise_bound) {
        record.field(
            option.about.name, [](Options& self) { return NoiseBound{self}; }, text);
        return;
      }
    }
    record.field(option.about.name, option.place, text);
  });
  for (const options::Gone& gone : options::Table<T>::gone) record.gone(gone.name, gone.advice);
  return record.settable();
}

/// The same with `validate()`.
template <class T>
nb::class_<T> bind_checked_options(nb::module_& module, const char* name, const char* doc) {
  return bind_options_of<T>(module, name, doc)
      .def("validate", &T::validate,
           "Raises ValueError naming the option and its value where one is out of range.");
}

}  // namespace gmcr::python
